# Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws distances, offset curves, paths, Voronoi cells and farthest points on a hilly surface, with matplotlib.

    plot_offsets.py [PICTURE.png]

Without a file the picture is shown. The parts between the lines `# %%` are cells for editors that run a script as a notebook.
"""

# %% A surface: hills over a square
import sys

import matplotlib.pyplot as plt
import numpy as np

import geodesic_offset

n = 80
x, y = (a.ravel() for a in np.meshgrid(np.linspace(-2, 2, n), np.linspace(-2, 2, n)))
points = np.column_stack([x, y, 0.6 * np.sin(2.5 * x) * np.cos(2 * y)])
corner = np.arange(n * (n - 1)).reshape(n - 1, n)[:, :-1].ravel()  # of each square
faces = np.vstack([np.column_stack([corner, corner + 1, corner + n + 1]), np.column_stack([corner, corner + n + 1, corner + n])])
mesh = geodesic_offset.Mesh(points, faces)

figure, axes = plt.subplots(2, 2, figsize=(11, 11), layout="constrained")
tolerance = 1e-3  # of polylines for curves


def draw(ax, title, values, **style):
    ax.tripcolor(x, y, faces, values, shading="gouraud" if len(values) == len(x) else "flat", **style)
    ax.set_title(title)
    ax.set_aspect("equal")
    ax.set_axis_off()


# %% Distances from a polyline, and its offset curves on both sides
line = mesh.locate_polyline(np.array([[-1.2, -0.8, 0], [0.1, 0.2, 0], [1.1, -0.5, 0]]))
draw(axes[0, 0], "offset curves", mesh.distances(line), cmap="viridis")
for curve in mesh.offsets(line, geodesic_offset.Levels.equally_spaced(0.25)):
    axes[0, 0].plot(*curve.points(tolerance).T[:2], "w", linewidth=1)

# %% Shortest paths to two points
field = mesh.field([np.array([-1.5, 1.4, 0]), np.array([1.3, 1, 0])], keep_windows=True)
draw(axes[0, 1], "shortest paths to two points", field.distances(), cmap="cividis")
for start in np.array([[a, -1.9, 0] for a in np.linspace(-1.8, 1.8, 13)]):
    axes[0, 1].plot(*field.shortest_path_points_to_sources(start).T[:2], "w", linewidth=1)

# %% Farthest points, and their Voronoi cells
samples = mesh.farthest_points(25, start_set=0)
sources = [0, *samples.vertices.tolist()]
diagram = mesh.voronoi(sources)
draw(axes[1, 0], "farthest points and their Voronoi cells", diagram.source_at_face() * 7 % len(sources), cmap="tab20")
for curve in diagram.curves:
    axes[1, 0].plot(*curve.points(tolerance).T[:2], "k", linewidth=1)
axes[1, 0].plot(x[sources], y[sources], "wo", markeredgecolor="k")

# %% Bands of a mesh that is split along offset curves of a point
split = mesh.split(mesh.offsets(np.array([0.3, 0.2, 0]), np.arange(0.3, 3, 0.3)))
axes[1, 1].tripcolor(*split.points.T[:2], split.faces, split.face_band % 2, cmap="Pastel1")
axes[1, 1].triplot(*split.points.T[:2], split.faces, color="gray", linewidth=0.2)
axes[1, 1].set(title="a mesh that is split along offset curves", aspect="equal")
axes[1, 1].set_axis_off()

# %% The picture
if len(sys.argv) > 1:
    figure.savefig(sys.argv[1], dpi=100)
else:
    plt.show()
