// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/simulation/program.h>

#include <fcntl.h>
#include <iostream>
#include <sstream>
#include <string>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

namespace
{
  constexpr char separator = '\x1f';

  constexpr int not_started = 125;



  /// Lets a stream of this process go to a file.
  bool
  redirect(const int stream, const std::string &name, const int flags)
  {
    const int file = open(name.c_str(), flags, 0600);
    return file >= 0 && dup2(file, stream) >= 0 && close(file) == 0;
  }



  /// What main() of the program does, in another folder.
  int
  run(const std::string &folder, std::vector<std::string> &arguments)
  {
    constexpr int anew = O_WRONLY | O_CREAT | O_TRUNC;
    if (!redirect(STDIN_FILENO, "/dev/null", O_RDONLY) ||
        !redirect(STDOUT_FILENO, folder + ".out", anew) ||
        !redirect(STDERR_FILENO, folder + ".err", anew) ||
        chdir(folder.c_str()) != 0)
      return not_started;
    std::vector<char *> words;
    words.reserve(arguments.size());
    for (std::string &argument : arguments)
      words.push_back(argument.data());
    return Thalweg::run_program(words.size(), words.data());
  }
} // namespace



/**
 * Runs the program many times: for each line "FOLDER\x1fARGUMENT\x1f..." of
 * its input, the name of the program first, in that folder and in a process of
 * its own, of which it prints the exit code (or minus the signal that ended
 * it). The streams go to FOLDER.out and FOLDER.err. What takes a process most
 * of its time, to find its place in two hundred libraries, is done once.
 */
int
main()
{
  std::string line;
  while (std::getline(std::cin, line))
    {
      std::istringstream       stream(line);
      std::string              folder, argument;
      std::vector<std::string> arguments;
      std::getline(stream, folder, separator);
      while (std::getline(stream, argument, separator))
        arguments.push_back(argument);
      const pid_t child = fork();
      if (child == 0)
        return run(folder, arguments);
      int status = 0;
      if (child < 0 || waitpid(child, &status, 0) != child)
        return not_started;
      std::cout << (WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status))
                << std::endl;
    }
  return 0;
}
