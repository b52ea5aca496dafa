# SPDX-License-Identifier: Apache-2.0
"""Atoms: a crystal made from scratch, a virus capsid put together from its asymmetric unit."""
import gzip

import numpy as np


def save_xyz(path, comment, names, positions):
    """`names`: one for all or one for each."""
    names = np.broadcast_to(names, len(positions))
    with open(path, "wb") as raw, gzip.GzipFile("", "wb", 6, raw, mtime=0) as packed:
        packed.write(f"{len(positions)}\n{comment}\n".encode())
        rows = [f"{name} {x:.3f} {y:.3f} {z:.3f}\n" for name, (x, y, z) in zip(names, positions.tolist())]
        packed.write("".join(rows).encode())


def crystal_ball(count=1_000_000, cell=4.09, jitter=0.12, seed=7):
    """The `count` sites of a face-centred cubic lattice (silver's, in ångström) nearest to its middle, without an
    octant at +x +y +z; round grains of gold in it; each atom moved a little as by heat."""
    side = int(np.ceil((count / 4.0 * 8.0 / 7.0 * 3.0 / (4.0 * np.pi)) ** (1.0 / 3.0))) + 2
    axis = np.arange(-side, side + 1, dtype=float)
    cells = np.stack(np.meshgrid(axis, axis, axis, indexing="ij"), -1).reshape(-1, 3)
    sites = np.vstack([cells + offset for offset in ((0, 0, 0), (0, 0.5, 0.5), (0.5, 0, 0.5), (0.5, 0.5, 0))])
    sites = sites[~np.all(sites > 0.0, axis=1)]
    sites = cell * sites[np.argsort(np.linalg.norm(sites, axis=1), kind="stable")[:count]]
    random = np.random.default_rng(seed)
    radius = np.linalg.norm(sites[-1])
    gold = np.zeros(count, bool)
    for middle in random.uniform(-0.75, 0.75, (40, 3)) * radius:
        gold |= np.linalg.norm(sites - middle, axis=1) < random.uniform(0.08, 0.2) * radius
    return np.where(gold, "Au", "Ag"), sites + random.normal(0.0, jitter, sites.shape)


def capsid(path):
    """All copies of the atoms of a PDB entry that its REMARK 350 asks for."""
    names, atoms, rows = [], [], []
    with gzip.open(path, "rt") as lines:
        for line in lines:
            if line.startswith(("ATOM  ", "HETATM")):
                names.append(line[76:78].strip().capitalize())
                atoms.append([float(line[column:column + 8]) for column in (30, 38, 46)])
            elif line.startswith("REMARK 350   BIOMT"):
                rows.append([float(word) for word in line[23:].split()])
    operators = np.array(rows).reshape(-1, 3, 4)
    atoms = np.array(atoms)
    copies = np.concatenate([atoms @ operator[:, :3].T + operator[:, 3] for operator in operators])
    return np.tile(names, len(operators)), copies
