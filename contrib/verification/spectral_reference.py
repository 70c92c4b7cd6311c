#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Computes reference/taylor_green_3d.csv: the kinetic energy of the Taylor-Green
vortices in 3D at Re = 100 by a Fourier-Galerkin method with the 3/2 rule's
truncation (2/3 of the modes) and the classical Runge-Kutta scheme, viscosity
exactly. Needs NumPy; takes some minutes."""

import csv
import pathlib
import sys

import numpy as np

N = int(sys.argv[1]) if len(sys.argv) > 1 else 64
NU, DT, END = .01, .02, 10.

x = 2 * np.pi * np.arange(N) / N
X, Y, Z = np.meshgrid(x, x, x, indexing="ij")
k = np.fft.fftfreq(N, 1 / N)
K = np.array(np.meshgrid(k, k, np.abs(k[:N // 2 + 1]), indexing="ij"))
K2 = np.sum(K * K, axis=0)
INVERSE = 1 / np.where(K2 == 0, 1, K2)
KEPT = np.all(np.abs(K) < N / 3, axis=0)
HALF = np.exp(-NU * K2 * DT / 2)


def forward(u):
    return np.array([np.fft.rfftn(c) for c in u])


def backward(u):
    return np.array([np.fft.irfftn(c, s=(N, N, N)) for c in u])


def convection(u):
    """u x curl u without its divergence."""
    curl = backward(1j * np.cross(K, u, axis=0))
    n = forward(np.cross(backward(u), curl, axis=0)) * KEPT
    return n - K * (np.sum(K * n, axis=0) * INVERSE)


def energy(u):
    """The mean of |u|^2/2."""
    return .5 * np.mean(np.sum(backward(u) ** 2, axis=0))


def main():
    u = forward(np.array([np.sin(X) * np.cos(Y) * np.cos(Z),
                          -np.cos(X) * np.sin(Y) * np.cos(Z), 0 * X]))
    first = energy(u)
    rows = [[0., 1.]]
    for step in range(1, round(END / DT) + 1):
        a = DT * convection(u)
        b = DT * convection(HALF * (u + a / 2))
        c = DT * convection(HALF * u + b / 2)
        d = DT * convection(HALF * (HALF * u + c))
        u = HALF ** 2 * u + (HALF ** 2 * a + 2 * HALF * (b + c) + d) / 6
        if step % 10 == 0:
            rows.append([step * DT, energy(u) / first])
    path = pathlib.Path(__file__).parent / "reference" / "taylor_green_3d.csv"
    with open(path, "w", newline="") as file:
        file.write("# Taylor-Green vortices in 3D, Re = 100, by "
                   f"spectral_reference.py with {N}^3 points.\n")
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(["time [s]", "relative kinetic energy"])
        writer.writerows([f"{t:.4g}", f"{e:.8f}"] for t, e in rows)


main()
