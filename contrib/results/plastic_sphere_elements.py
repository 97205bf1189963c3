#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""A sphere of a perfectly plastic solid between two rigid plates by axisymmetric finite elements: Hencky's elasticity, von Mises' yield
stress of Kirchhoff, 8-node elements with four points. The reference of doc/results/three-dimensions.md. R = E = 1."""
import argparse

import numpy as np
import scipy.sparse as sparse
from scipy.sparse.linalg import splu


def mesh(n, power):
    """Quarter of a meridian: squares mapped to a quarter of a disk, finer towards the pole. Nodes, elements of eight nodes, edges of the arc."""
    line = np.linspace(0, 1, 2 * n + 1)
    s, t = np.meshgrid(line**power, 1 - (1 - line) ** power, indexing="ij")
    nodes = np.stack([s * np.sqrt(1 - t**2 / 2), t * np.sqrt(1 - s**2 / 2)], axis=-1).reshape(-1, 2)
    at = np.arange((2 * n + 1) ** 2).reshape(2 * n + 1, -1)
    elements, edges = [], []
    for i in range(0, 2 * n, 2):
        for j in range(0, 2 * n, 2):
            elements.append([at[i, j], at[i + 2, j], at[i + 2, j + 2], at[i, j + 2],
                             at[i + 1, j], at[i + 2, j + 1], at[i + 1, j + 2], at[i, j + 1]])
    for i in range(0, 2 * n, 2):
        edges.append([at[i, -1], at[i + 1, -1], at[i + 2, -1]])
    for j in range(2 * n, 0, -2):
        edges.append([at[-1, j], at[-1, j - 1], at[-1, j - 2]])
    elements, edges = np.array(elements), np.array(edges)
    # Middles of sides half-way between corners, but for those of the arc.
    for a, b, m in ((0, 1, 4), (1, 2, 5), (2, 3, 6), (3, 0, 7)):
        nodes[elements[:, m]] = 0.5 * (nodes[elements[:, a]] + nodes[elements[:, b]])
    middle = nodes[edges[:, 0]] + nodes[edges[:, 2]]
    nodes[edges[:, 1]] = middle / np.linalg.norm(middle, axis=1)[:, None]
    used = np.unique(elements)
    new = np.full(len(nodes), -1)
    new[used] = np.arange(len(used))
    return nodes[used], new[elements], new[edges]


def shapes():
    """Values and slopes of the eight functions at 2 x 2 points."""
    g = 1 / np.sqrt(3)
    values, slopes = [], []
    corner = np.array([(-1, -1), (1, -1), (1, 1), (-1, 1)])
    for x, y in ((-g, -g), (g, -g), (g, g), (-g, g)):
        N, D = np.zeros(8), np.zeros((8, 2))
        for k, (a, b) in enumerate(corner):
            N[k] = 0.25 * (1 + a * x) * (1 + b * y) * (a * x + b * y - 1)
            D[k] = 0.25 * a * (1 + b * y) * (2 * a * x + b * y), 0.25 * b * (1 + a * x) * (2 * b * y + a * x)
        for k, (a, b) in enumerate(((0, -1), (1, 0), (0, 1), (-1, 0))):
            if a == 0:
                N[4 + k] = 0.5 * (1 - x * x) * (1 + b * y)
                D[4 + k] = -x * (1 + b * y), 0.5 * b * (1 - x * x)
            else:
                N[4 + k] = 0.5 * (1 + a * x) * (1 - y * y)
                D[4 + k] = 0.5 * a * (1 - y * y), -y * (1 + a * x)
        values.append(N)
        slopes.append(D)
    return np.array(values), np.array(slopes)


class Sphere:
    def __init__(self, n, power, poisson, yield_stress, stiffness):
        self.nodes, self.elements, self.edges = mesh(n, power)
        self.mu, self.bulk, self.Y = 0.5 / (1 + poisson), 1 / (3 * (1 - 2 * poisson)), yield_stress
        self.stiffness = stiffness
        N, D = shapes()
        X = self.nodes[self.elements]
        J = np.einsum("pkd,eki->epid", D, X)
        self.N, self.R = N, np.einsum("pk,ek->ep", N, X[..., 0])
        self.G = np.einsum("pkd,epdi->epki", D, np.linalg.inv(J))
        self.V = 2 * np.pi * self.R * np.linalg.det(J)
        self.dofs = (2 * self.elements[..., None] + np.arange(2)).reshape(len(self.elements), 16)
        shape = self.V.shape
        self.Cp = np.zeros(shape + (3, 3)) + np.eye(3)  # inverse of the plastic right Cauchy-Green
        self.alpha, self.lost, self.load = np.zeros(shape), 0.0, 0.0
        g = np.sqrt(0.6)
        s = np.array([-g, 0, g])
        self.edge_N = np.stack([0.5 * s * (s - 1), 1 - s * s, 0.5 * s * (s + 1)], axis=1)
        self.edge_D = np.stack([s - 0.5, -2 * s, s + 0.5], axis=1)
        self.edge_w = np.array([5, 8, 5]) / 9
        fixed = np.zeros(2 * len(self.nodes), bool)
        fixed[0::2] = self.nodes[:, 0] < 1e-12
        fixed[1::2] = self.nodes[:, 1] < 1e-12
        self.free = np.where(~fixed)[0]

    def response(self, U):
        """Kirchhoff's stress (principal frame folded in) and what the points keep, for displacements of elements U[e, 8, 2]."""
        F = np.zeros(U.shape[:1] + (4, 3, 3))
        F[..., :2, :2] = np.eye(2) + np.einsum("eki,epkj->epij", U, self.G)
        F[..., 2, 2] = 1 + np.einsum("pk,ek->ep", self.N, U[..., 0]) / self.R
        be = np.einsum("epij,epjk,eplk->epil", F, self.Cp, F)
        # Eigenvalues of the 2 x 2 part in closed form; the hoop stands alone.
        half, diff, off = 0.5 * (be[..., 0, 0] + be[..., 1, 1]), 0.5 * (be[..., 0, 0] - be[..., 1, 1]), be[..., 0, 1]
        root = np.sqrt(diff**2 + off**2) + 1e-300
        e = 0.5 * np.log(np.stack([half + root, half - root, be[..., 2, 2]], axis=-1))
        volume = e.sum(-1)
        dev = e - volume[..., None] / 3
        q = 2 * self.mu * np.sqrt(1.5) * np.linalg.norm(dev, axis=-1)
        plastic = np.maximum(0, q - self.Y) / (3 * self.mu)
        scale = np.where(q > self.Y, self.Y / np.maximum(q, 1e-300), 1.0)
        dev_e = dev * scale[..., None]
        tau = 2 * self.mu * dev_e + (self.bulk * volume)[..., None]
        c, s = diff / root, off / root  # cosine and sine of twice the angle
        full = np.zeros_like(be)
        mean, half_difference = 0.5 * (tau[..., 0] + tau[..., 1]), 0.5 * (tau[..., 0] - tau[..., 1])
        full[..., 0, 0], full[..., 1, 1] = mean + half_difference * c, mean - half_difference * c
        full[..., 0, 1] = full[..., 1, 0] = half_difference * s
        full[..., 2, 2] = tau[..., 2]
        return F, full, e, dev_e + volume[..., None] / 3, (c, s), plastic

    def force(self, U):
        F, tau, _, _, _, _ = self.response(U)
        inverse = np.linalg.inv(F)
        P = np.einsum("epij,epkj->epik", tau, inverse)
        f = np.einsum("ep,epij,epkj->eki", self.V, P[..., :2, :2], self.G)
        f[..., 0] += np.einsum("ep,ep,pk->ek", self.V, P[..., 2, 2] / self.R, self.N)
        return f.reshape(len(U), 16)

    def keep(self, U):
        F, _, trial, elastic, (c, s), plastic = self.response(U)
        stretch = np.exp(2 * elastic)
        be = np.zeros(F.shape)
        mean, half = 0.5 * (stretch[..., 0] + stretch[..., 1]), 0.5 * (stretch[..., 0] - stretch[..., 1])
        be[..., 0, 0], be[..., 1, 1] = mean + half * c, mean - half * c
        be[..., 0, 1] = be[..., 1, 0] = half * s
        be[..., 2, 2] = stretch[..., 2]
        inverse = np.linalg.inv(F)
        self.Cp = np.einsum("epij,epjk,eplk->epil", inverse, be, inverse)
        self.alpha += plastic
        self.lost += self.Y * (plastic * self.V).sum()

    def contact(self, u, plate):
        """Penalty of the plate at height @plate: force on the dofs, its stiffness, sum, and radius of what touches."""
        x = self.nodes + u.reshape(-1, 2)
        x = x[self.edges]
        z = np.einsum("gk,ek->eg", self.edge_N, x[..., 1])
        r = np.einsum("gk,ek->eg", self.edge_N, self.nodes[self.edges][..., 0])
        length = np.linalg.norm(np.einsum("gk,eki->egi", self.edge_D, self.nodes[self.edges]), axis=-1)
        weight = 2 * np.pi * r * length * self.edge_w
        deep = np.maximum(0, z - plate)
        pressure = self.stiffness * deep
        f = np.zeros(2 * len(self.nodes))
        np.add.at(f, 2 * self.edges + 1, np.einsum("eg,gk->ek", pressure * weight, self.edge_N))
        k = np.einsum("eg,gk,gl->ekl", self.stiffness * (deep > 0) * weight, self.edge_N, self.edge_N)
        d = 2 * self.edges + 1
        K = sparse.coo_matrix((k.ravel(), (np.repeat(d, 3, 1).ravel(), np.tile(d, (1, 3)).ravel())), shape=(len(f),) * 2)
        radius = np.einsum("gk,ek->eg", self.edge_N, x[..., 0])[deep > 0].max(initial=0.0)
        return f, K, (pressure * weight).sum(), radius

    def rest(self, u, plate):
        """What is unbalanced at the free dofs, its scale, the stiffness of contact, load and radius of what touches."""
        total = np.zeros(2 * len(self.nodes))
        np.add.at(total, self.dofs, self.force(u.reshape(-1, 2)[self.elements]))
        fc, Kc, load, radius = self.contact(u, plate)
        return (total + fc)[self.free], max(np.abs(fc).sum(), 1e-9), Kc, load, radius

    def matrix(self, u, Kc):
        """Slope of what is unbalanced, by central differences, element by element."""
        U = u.reshape(-1, 2)[self.elements].reshape(-1, 16)
        K, h = np.empty((len(U), 16, 16)), 1e-8
        for k in range(16):
            V, W = U.copy(), U.copy()
            V[:, k] += h
            W[:, k] -= h
            K[:, :, k] = (self.force(V.reshape(-1, 8, 2)) - self.force(W.reshape(-1, 8, 2))) / (2 * h)
        rows, columns = np.repeat(self.dofs, 16, 1).ravel(), np.tile(self.dofs, (1, 16)).ravel()
        A = sparse.coo_matrix((K.ravel(), (rows, columns)), shape=(len(u),) * 2) + Kc
        return A.tocsc()[self.free][:, self.free]

    def balance(self, u, plate):
        """Newton's method with halved ways; None where it does not come to balance."""
        rest, scale, Kc, load, radius = self.rest(u, plate)
        for iteration in range(30):
            if np.linalg.norm(rest) < 1e-8 * scale:
                return u, load, radius, iteration
            du = np.zeros_like(u)
            du[self.free] = splu(self.matrix(u, Kc)).solve(-rest)
            share = min(1, 0.05 / np.abs(du).max())
            for _ in range(6):
                to = u + share * du
                found = self.rest(to, plate)
                if np.linalg.norm(found[0]) < np.linalg.norm(rest):
                    break
                share *= 0.5
            u = to
            rest, scale, Kc, load, radius = found
        return None

    def go(self, u, start, end, depth=0):
        """To the plate at height @end, in halves where that is too far. Returns displacements, load, radius, work, iterations."""
        found = self.balance(u, end)
        if found is not None:
            self.keep(found[0].reshape(-1, 2)[self.elements])
            work = 0.5 * (self.load + found[1]) * (start - end)
            self.load = found[1]
            return (*found[:3], work, found[3])
        if depth == 6:
            raise SystemExit("no balance")
        first = self.go(u, start, 0.5 * (start + end), depth + 1)
        second = self.go(first[0], 0.5 * (start + end), end, depth + 1)
        return (*second[:3], first[3] + second[3], first[4] + second[4])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--elements", type=int, default=20, help="along a side")
    parser.add_argument("--power", type=float, default=1.4, help="of the grading towards the pole")
    parser.add_argument("--poisson", type=float, default=0.3)
    parser.add_argument("--yield-stress", type=float, default=0.05, help="over Young's modulus")
    parser.add_argument("--last", type=float, default=0.3, help="travel of a plate over the radius")
    parser.add_argument("--step", type=float, default=0.005)
    parser.add_argument("--penalty", type=float, default=300.0)
    arguments = parser.parse_args()
    sphere = Sphere(arguments.elements, arguments.power, arguments.poisson, arguments.yield_stress, arguments.penalty)
    print(f"# {len(sphere.elements)} elements, volume off by {sphere.V.sum() / (2 * np.pi / 3) - 1:.1e}")
    print("# d/R F/(E R^2) F/(Y R^2) a/R F/(pi a^2 Y) largest plastic strain, lost over work")
    u, work, Y = np.zeros(2 * len(sphere.nodes)), 0.0, arguments.yield_stress
    for k in range(1, round(arguments.last / arguments.step) + 1):
        d = k * arguments.step
        u, load, radius, more, iterations = sphere.go(u, 1 - d + arguments.step, 1 - d)
        work += more
        print(f"{d:.4f} {load:.6g} {load / Y:.6g} {radius:.4f} {load / (np.pi * max(radius, 1e-9) ** 2 * Y):.4f}"
              f" {sphere.alpha.max():.4f} {sphere.lost / work:.4f} it {iterations}", flush=True)


if __name__ == "__main__":
    main()
