// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/fields/expression.h>

#include <deal.II/lac/vector.h>

#include <gtest/gtest.h>

#include "support/complaint.h"

using namespace Thalweg;

namespace
{
  std::string
  expression_complaint(const std::string &text)
  {
    return complaint_of([&]() { parse_expression<2>(text, 1, "Here"); });
  }
} // namespace



TEST(Expression, CommasSeparateArgumentsOnly)
{
  for (const char *text : {"max(x, y)",
                           "max (x, 1)",
                           "if(x < 0.5, min(1, (y)), 2)",
                           "(pow(x, 2))*atan2(y, x + 1)"})
    EXPECT_EQ(expression_complaint(text), "") << text;
  for (const char *text :
       {"y - 0,5", "0,5", "(1,5)*x", "max(x, (1,5))", "2*(x,y)", "x , 1"})
    EXPECT_NE(expression_complaint(text).find("separates no arguments"),
              std::string::npos)
      << text;
  EXPECT_NE(expression_complaint("y - 10,25*x").find("with a point: '10.25'"),
            std::string::npos);
}



TEST(Expression, RefusesWhatIsNoFiniteNumberWhereItIsEvaluated)
{
  const auto function = parse_expression<2>("1/x + sqrt(y)", 1, "Here");
  function->set_time(3.);
  EXPECT_EQ(function->value({.5, 4.}), 4.);
  const auto at = [&](const dealii::Point<2> &x) {
    return complaint_of([&]() { function->value(x); });
  };
  EXPECT_NE(at({0., 4.}).find("The expression 'Here = 1/x + sqrt(y)' is "
                              "infinite at (0 4), t = 3 s."),
            std::string::npos);
  EXPECT_NE(at({1., -4.}).find("is not a number at (1 -4)"), std::string::npos);
}



TEST(Expression, NamesTheComponentThatIsNotFinite)
{
  const auto function = parse_expression<2>("1; 1/(x - 1)", 2, "Here");
  dealii::Vector<double> value(2);
  EXPECT_NE(complaint_of([&]() {
              function->vector_value(dealii::Point<2>(1., 0.), value);
            }).find("(its component 2)"),
            std::string::npos);
}



TEST(Expression, FaultsAreRememberedWhereSomebodyAsksForThemLater)
{
  const auto function = parse_expression<2>("1/x", 1, "Here");
  {
    const ExpressionFaults faults;
    EXPECT_EQ(complaint_of([&]() { faults.check(); }), "");
    EXPECT_EQ(function->value({.5, 0.}), 2.);
    EXPECT_EQ(function->value({0., 1.}), 0.);
    EXPECT_EQ(function->value({0., 2.}), 0.);
    EXPECT_NE(complaint_of([&]() { faults.check(); }).find("at (0 1)"),
              std::string::npos);
  }
  EXPECT_NE(complaint_of([&]() { function->value({0., 1.}); }), "");
}



TEST(Expression, KnowsWhetherItDependsOnTime)
{
  for (const char *text : {"t", "sin(2*t)", "x*t", "t+1; 0"})
    EXPECT_TRUE(mentions_time(text)) << text;
  for (const char *text : {"x", "sqrt(x)", "tan(y)", "at", "t_1", ""})
    EXPECT_FALSE(mentions_time(text)) << text;
}
