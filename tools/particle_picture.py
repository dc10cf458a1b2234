#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""A picture of one frame: particles as a softly lit surface, coloured as baked goods or by any column.

    tools/particle_picture.py results/bread-draft/frames/0480.hdf loaf.png
    tools/particle_picture.py frame.hdf temperature.png --by temperature --cut y=0

Needs numpy, h5py and matplotlib (Debian: python3-numpy python3-h5py python3-matplotlib).

How: particles are splatted as balls into a depth buffer, seen in parallel projection; the depth is smoothed where it is smooth,
so that the picture shows the body and not its particles; normals, soft shadow, and darkening of crevices follow from depths.
"""
import argparse

import h5py
import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.colors import LinearSegmentedColormap

WIDTH, HEIGHT, OVERSAMPLING = 1280, 960, 2
BAKED = LinearSegmentedColormap.from_list("baked", [
    (0.00, (0.95, 0.87, 0.69)), (0.35, (0.90, 0.72, 0.43)), (0.65, (0.76, 0.48, 0.20)), (1.00, (0.42, 0.21, 0.08))])
GROUND = np.array([0.93, 0.92, 0.90])
CHIP = np.array([0.22, 0.11, 0.06])


def read_frame(path):
    with h5py.File(path) as file:
        data = {name: column[()] for name, column in file["VTKHDF/PointData"].items()}
        units = {name: column.attrs["unit"] for name, column in file["VTKHDF/PointData"].items()}
        units = {name: unit.decode() if isinstance(unit, bytes) else unit for name, unit in units.items()}
        return file["VTKHDF/Points"][()].astype(float), data, units


def direction(azimuth_deg, height_deg):
    a, h = np.radians([azimuth_deg, height_deg])
    return np.array([np.cos(h) * np.cos(a), np.cos(h) * np.sin(a), np.sin(h)])


class View:
    """Parallel projection onto a raster: x to the right, y downwards, depth away from the eye; all in metres but for the raster."""

    def __init__(self, toward_eye, points, width, height, margin):
        self.toward = toward_eye
        self.right = np.cross([0.0, 0.0, 1.0], toward_eye)
        self.right /= np.linalg.norm(self.right)
        self.up = np.cross(toward_eye, self.right)
        across, upward = points @ self.right, points @ self.up
        self.width, self.height = width, height
        self.scale = min(width / np.ptp(across), height / np.ptp(upward)) / margin  # raster points per metre
        self.left = across.min() + np.ptp(across) / 2 - width / 2 / self.scale
        self.top = upward.min() + np.ptp(upward) / 2 + height / 2 / self.scale

    def raster(self, points):
        return (points @ self.right - self.left) * self.scale, (self.top - points @ self.up) * self.scale, -(points @ self.toward)

    def rays(self):
        """World position, on the plane through the origin that faces the eye, of each raster point."""
        across = self.left + (np.arange(self.width) + 0.5) / self.scale
        upward = self.top - (np.arange(self.height) + 0.5) / self.scale
        return across[None, :, None] * self.right + upward[:, None, None] * self.up


def splat(view, points, radius):
    """Depth buffer of balls and the ball seen at each raster point (-1: none)."""
    x, y, depth = view.raster(points)
    far_to_near = np.argsort(-depth)
    column, row = np.floor(x[far_to_near]).astype(int), np.floor(y[far_to_near]).astype(int)
    centre_depth = depth[far_to_near]
    buffer = np.full(view.height * view.width, np.inf)
    seen = np.full(view.height * view.width, -1)
    reach = radius * view.scale
    steps = range(-int(reach), int(reach) + 1)
    for dy in steps:
        for dx in steps:
            inside = 1 - (dx * dx + dy * dy) / (reach * reach)
            if inside <= 0:
                continue
            r, c = row + dy, column + dx
            at = r * view.width + c
            here = centre_depth - radius * np.sqrt(inside)
            in_picture = (r >= 0) & (r < view.height) & (c >= 0) & (c < view.width)
            nearer = np.flatnonzero(in_picture)[here[in_picture] < buffer[at[in_picture]]]
            buffer[at[nearer]] = here[nearer]  # far to near: of several balls at one point the nearest is written last
            seen[at[nearer]] = far_to_near[nearer]
    return buffer.reshape(view.height, view.width), seen.reshape(view.height, view.width)


def blur(image, width):
    """Three box filters of the given half width: nearly a Gaussian."""
    half = max(1, int(round(width)))
    for _ in range(3):
        for axis in (0, 1):
            pad = [(0, 0)] * image.ndim
            pad[axis] = (half + 1, half)
            total = np.cumsum(np.pad(image, pad, mode="edge"), axis=axis)
            front = np.take(total, range(2 * half + 1, total.shape[axis]), axis=axis)
            back = np.take(total, range(0, total.shape[axis] - 2 * half - 1), axis=axis)
            image = (front - back) / (2 * half + 1)
    return image


def smooth_depth(depth, covered, reach, radius):
    """Smooths the depth where it is continuous: values further than two radii from the local mean do not mix."""
    smooth = np.where(covered, depth, 0)
    for width in (reach, reach, reach / 2):
        mean = blur(smooth * covered, width) / np.maximum(blur(covered.astype(float), width), 1e-9)
        near = covered & (np.abs(smooth - mean) < 2 * radius)
        share = blur(near.astype(float), width)
        mixed = blur(np.where(near, smooth, 0), width) / np.maximum(share, 1e-9)
        smooth = np.where(near & (share > 0.02), mixed, smooth)
    return smooth


def masked_blur(image, covered, width):
    weight = np.maximum(blur(covered.astype(float), width), 1e-9)
    shape = image.shape[:2] + (1,) * (image.ndim - 2)
    return blur(np.where(covered.reshape(shape), image, 0), width) / weight.reshape(shape)


def normals(view, depth):
    down, right = np.gradient(depth * view.scale)
    n = view.toward + right[..., None] * view.right - down[..., None] * view.up
    return n / np.linalg.norm(n, axis=2, keepdims=True)


def light_reaching(lamp, buffer, world, radius, softness):
    """Share of the lamp's light at world positions, by the depth buffer seen from the lamp, softened."""
    x, y, depth = lamp.raster(world.reshape(-1, 3))
    lit = np.zeros(len(depth))
    rng = np.random.default_rng(1)
    taps = rng.normal(size=(24, 2)) * softness * lamp.scale
    for dx, dy in taps:
        column = np.clip((x + dx).astype(int), 0, lamp.width - 1)
        row = np.clip((y + dy).astype(int), 0, lamp.height - 1)
        lit += depth < buffer[row, column] + 2.5 * radius
    return (lit / len(taps)).reshape(world.shape[:2])


def browning(data):
    """From raw (0) to dark (1): dough browns where it has been hot and has lost its water."""
    if "peak_temperature" not in data:
        return np.full(len(data["id"]), 0.3)
    peak = data["peak_temperature"].astype(float)
    heat = np.clip((peak - 40) / 60, 0, 1.6)
    if "water_mass" not in data:
        return np.clip(0.75 * heat, 0, 1)
    water = data["water_mass"] / np.quantile(data["water_mass"], 0.9)
    return np.clip(0.25 * heat + heat * np.clip((1 - water) / 0.5, 0, 1) * 0.75, 0, 1)


def base_colours(data, arguments):
    """Colour of each particle, and (values, map, limits) if there is a colour bar."""
    if arguments.by is None:
        colours = BAKED(browning(data))[:, :3]
        colours[data["material"] > 0] = CHIP
        return colours, None
    if arguments.by not in data:
        raise SystemExit(f"{arguments.frame}: no column '{arguments.by}', there are: {', '.join(sorted(data))}")
    values = data[arguments.by].astype(float)
    if values.ndim == 2:
        values = np.linalg.norm(values, axis=1)
    limits = arguments.limits or np.quantile(values, [0.005, 0.995])
    scale = plt.Normalize(*limits)
    return plt.get_cmap("viridis")(scale(values))[:, :3], scale


def kept_by_cut(points, cut):
    if cut is None:
        return np.ones(len(points), bool)
    axis, at = cut.split("=")
    return points[:, "xyz".index(axis)] >= float(at)


def render(points, colours, arguments):
    w, h = WIDTH * OVERSAMPLING, HEIGHT * OVERSAMPLING
    low, high = points.min(axis=0), points.max(axis=0)
    spacing = arguments.spacing
    radius = 0.75 * spacing
    view = View(direction(*arguments.eye), points, w, h, 1.3)
    buffer, seen = splat(view, points, radius)
    reach = 0.45 * spacing * view.scale
    depth = smooth_depth(buffer, seen >= 0, reach, radius)
    base = masked_blur(np.where(seen[..., None] >= 0, colours[seen], 0), seen >= 0, reach) ** 2.2
    covered = blur((seen >= 0).astype(float), 1.5 * reach) > 0.6  # the outline without the scallops of single balls
    depth = np.where(seen >= 0, depth, masked_blur(depth, seen >= 0, reach))
    floor = low[2] - 0.3 * spacing

    on_plane = view.rays()
    ground_depth = (floor - on_plane[..., 2]) / -view.toward[2]  # depth d at z = floor: on_plane - d toward
    world = on_plane - np.where(covered, depth, ground_depth)[..., None] * view.toward

    lamp_direction = direction(*arguments.lamp)
    lamp = View(lamp_direction, points, 1000, 1000, 1.3)
    lamp_buffer, _ = splat(lamp, points, radius)
    lit = light_reaching(lamp, lamp_buffer, world, radius, 0.02 * np.linalg.norm(high - low))
    lit = np.where(covered, masked_blur(lit, covered, reach), blur(lit, 0.006 * w))

    n = normals(view, depth)
    for _ in range(2):
        n = masked_blur(n, covered, reach / 2)
    n /= np.maximum(np.linalg.norm(n, axis=2, keepdims=True), 1e-9)
    size = 0.03 * w
    hollow = np.clip((depth - masked_blur(depth, covered, size)) / (2.5 * spacing + 0.05 * np.ptp(points[:, 2])), 0, 1) * covered
    near_ground = np.exp(-np.maximum(world[..., 2] - floor, 0) / (0.12 * np.ptp(points[:, 2]) + spacing))
    sky = (0.5 + 0.5 * n[..., 2]) * (1 - 0.55 * hollow) * (1 - 0.35 * near_ground)
    sun = np.clip(n @ lamp_direction, 0, 1) * lit
    half_way = lamp_direction + view.toward
    gloss = np.clip(n @ (half_way / np.linalg.norm(half_way)), 0, 1) ** 30 * lit * 0.035
    body = base * (0.6 * sky + 0.95 * sun)[..., None] + gloss[..., None]

    under = blur(covered.astype(float), 0.02 * w)
    ground = GROUND ** 2.2 * (0.42 + 0.58 * lit - 0.22 * under * (1 - covered))[..., None]
    fade = np.clip(np.linalg.norm(np.indices((h, w)).transpose(1, 2, 0) / [h, w] - 0.5, axis=2) - 0.35, 0, 1)
    ground = ground * (1 - 0.35 * fade)[..., None]

    picture = np.where(covered[..., None], body, ground)
    picture = picture.reshape(HEIGHT, OVERSAMPLING, WIDTH, OVERSAMPLING, 3).mean(axis=(1, 3))
    return np.clip(picture, 0, 1) ** (1 / 2.2)


def write(picture, scale, arguments, unit):
    if scale is None:
        small = np.round(picture * 255).astype(np.uint8)
        plt.imsave(arguments.picture, small, pil_kwargs={"optimize": True})
        return
    figure = plt.figure(figsize=(WIDTH / 100, HEIGHT / 100), dpi=100)
    figure.add_axes([0, 0, 1, 1]).imshow(picture)
    figure.axes[0].axis("off")
    bar = figure.add_axes([0.3, 0.06, 0.4, 0.022])
    figure.colorbar(matplotlib.cm.ScalarMappable(scale, "viridis"), bar, orientation="horizontal")
    bar.set_title(f"{arguments.by.replace('_', ' ')} [{unit}]", fontsize=13)
    figure.savefig(arguments.picture)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("frame", help="a frame NNNN.hdf")
    parser.add_argument("picture", help="the PNG to write")
    parser.add_argument("--by", help="colour by this column, with a colour bar, instead of by browning")
    parser.add_argument("--limits", nargs=2, type=float, help="ends of the colour bar")
    parser.add_argument("--cut", help="show only one side of a plane, e.g. y=0: the part with y >= 0")
    parser.add_argument("--eye", nargs=2, type=float, default=[-65, 32], help="azimuth and height of the eye [deg]")
    parser.add_argument("--lamp", nargs=2, type=float, default=[-150, 48], help="azimuth and height of the lamp [deg]")
    arguments = parser.parse_args()
    points, data, units = read_frame(arguments.frame)
    kept = kept_by_cut(points, arguments.cut)
    if not kept.any():
        raise SystemExit(f"{arguments.frame}: no particles to show")
    arguments.spacing = np.cbrt(np.median(data["volume"]))
    colours, scale = base_colours(data, arguments)
    write(render(points[kept], colours[kept], arguments), scale, arguments, units.get(arguments.by, ""))


if __name__ == "__main__":
    main()
