#!/usr/bin/env python3
"""Force that a uniform stress leaves on particles off a lattice, by how their volumes are chosen.

Usage: disorder.py [JITTER ...] (Python 3 with numpy). A stress S alike everywhere gives particle i of the engine's
scheme the force V_i S c_i with c_i = sum_j V_j omega_ij (M_i^-1 + M_j^-1) xi_ij (VB5); on a lattice c_i vanishes.
Printed for 30 x 30 particles a spacing of 1 apart between periodic sides: the RMS of the components of c_i with the
volumes of the cells, with those of the Voronoi cells, and after one step towards least squares of c_i that stays near
the cells' volumes (its least volume too: below zero it is of no use).
"""
import sys

import numpy

CELLS, RATIO = 30, 1.3  # 2h = 2.6 spacings, Wendland C2


def offsets(x):
    d = x[None] - x[:, None]
    return d - CELLS * numpy.round(d / CELLS)


def weights(d):
    q = numpy.hypot(d[..., 0], d[..., 1]) / RATIO
    w = numpy.where(q < 2, (1 - q / 2) ** 4 * (1 + 2 * q), 0)
    numpy.fill_diagonal(w, 0)
    return w


def inverse_moments(d, w, volume):
    return numpy.linalg.inv(numpy.einsum("ij,ija,ijb->iab", w * volume[None], d, d))


def left_over(d, w, volume):
    inverse, share = inverse_moments(d, w, volume), w * volume[None]
    own = numpy.einsum("iab,ib->ia", inverse, numpy.einsum("ij,ija->ia", share, d))
    return own + numpy.einsum("ij,jab,ijb->ia", share, inverse, d)


def voronoi_volumes(x, parts=20):
    """Areas by the nearest particle of parts x parts points a cell."""
    volume, line = numpy.zeros(len(x)), (numpy.arange(CELLS * parts) + 0.5) / parts - 0.5
    for a in line:
        d = numpy.stack([numpy.full(len(line), a), line], 1)[:, None] - x[None]
        d -= CELLS * numpy.round(d / CELLS)
        numpy.add.at(volume, (d ** 2).sum(-1).argmin(1), parts ** -2)
    return volume


def towards_least_squares(d, w, volume, stiffness=1e-3):
    inverse, n = inverse_moments(d, w, volume), len(volume)
    slope = numpy.einsum("ij,ijab,ijb->iaj", w, inverse[:, None] + inverse[None, :], d).reshape(2 * n, n)
    rows = numpy.vstack([slope, numpy.sqrt(stiffness) * numpy.eye(n)])
    return volume + numpy.linalg.lstsq(rows, numpy.concatenate([-left_over(d, w, volume).ravel(), numpy.zeros(n)]), rcond=None)[0]


def rms(c):
    return numpy.sqrt((c ** 2).mean())


def main():
    for jitter in [float(a) for a in sys.argv[1:]] or [0.1, 0.3]:
        lattice = numpy.stack([a.ravel() for a in numpy.meshgrid(*[numpy.arange(CELLS)] * 2, indexing="ij")], 1)
        x = lattice + numpy.random.default_rng(1).uniform(-jitter, jitter, lattice.shape)
        d = offsets(x)
        w, cells = weights(d), numpy.ones(len(x))
        best = towards_least_squares(d, w, cells)
        print(f"jitter {jitter}: cells {rms(left_over(d, w, cells)):.3f}, Voronoi {rms(left_over(d, w, voronoi_volumes(x))):.3f}, "
              f"least squares {rms(left_over(d, w, best)):.3f} with a least volume of {best.min():.2f}")


if __name__ == "__main__":
    main()
