# Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws the figures of the manual: figures.py FOLDER

Writes window.svg, offset_in_face.svg and polyline_windows.svg. All positions are computed from the sources and faces below.
"""

import math
import os
import sys

FACE = "#f3f3f0"
EDGE = "#8a8a85"
INK = "#222222"
SOURCE = "#c0392b"
OFFSET = "#111111"
RAY = "#2468a8"
BLUE = "#cfe2f5"
GREEN = "#d5ecd4"
ORANGE = "#fbe3c4"
VIOLET = "#e4d9f2"


class Vector(tuple):
    """Point or vector of the plane."""

    def __new__(cls, x, y):
        return super().__new__(cls, (x, y))

    def __add__(self, other):
        return Vector(self[0] + other[0], self[1] + other[1])

    def __sub__(self, other):
        return Vector(self[0] - other[0], self[1] - other[1])

    def __mul__(self, factor):
        return Vector(self[0] * factor, self[1] * factor)

    def dot(self, other):
        return self[0] * other[0] + self[1] * other[1]

    def cross(self, other):
        return self[0] * other[1] - self[1] * other[0]

    def length(self):
        return math.hypot(*self)

    def unit(self):
        return self * (1 / self.length())

    def left(self):
        return Vector(-self[1], self[0])


def line_meets_line(p, direction, a, b):
    """Point of the line through p on the line through a and b."""
    return p + direction * ((a - p).cross(b - a) / direction.cross(b - a))


def line_meets_circle(p, direction, center, radius):
    """Points of the line through p on the circle, along the direction."""
    u = direction.unit()
    middle = (center - p).dot(u)
    half = math.sqrt(radius ** 2 - (p + u * middle - center).dot(p + u * middle - center))
    return p + u * (middle - half), p + u * (middle + half)


class Drawing:
    """SVG file of a rectangle of the plane."""

    def __init__(self, low, high, scale):
        self.low, self.high, self.scale = low, high, scale
        self.parts = []

    def at(self, p):
        return "%.2f %.2f" % ((p[0] - self.low[0]) * self.scale, (self.high[1] - p[1]) * self.scale)

    def path(self, data, **style):
        attributes = "".join(' %s="%s"' % (name.replace("_", "-"), value) for name, value in style.items())
        self.parts.append('<path d="%s"%s/>' % (data, attributes))

    def polygon(self, points, fill, stroke="none", width=1.2):
        self.path("M %s Z" % " L ".join(map(self.at, points)), fill=fill, stroke=stroke, stroke_width=width,
                  stroke_linejoin="round")

    def line(self, points, color, width=1.5, dash=None):
        style = {"stroke_dasharray": dash} if dash else {}
        self.path("M " + " L ".join(map(self.at, points)), fill="none", stroke=color, stroke_width=width,
                  stroke_linecap="round", stroke_linejoin="round", **style)

    def arc_data(self, center, start, end):
        """SVG data of the counterclockwise arc to the point `end`, which is at most a half circle."""
        radius = (start - center).length()
        assert abs(radius - (end - center).length()) < 1e-9, "the ends of an arc have different distances from its centre"
        sweep = 0 if (start - center).cross(end - center) >= -1e-12 else 1
        return "A %.2f %.2f 0 0 %d %s" % (radius * self.scale, radius * self.scale, sweep, self.at(end))

    def curve(self, pieces, color, width):
        """Chain of points; a pair of a centre and a point is an arc to this point."""
        self.path(self.chain(pieces), fill="none", stroke=color, stroke_width=width, stroke_linejoin="round")

    def region(self, pieces, fill):
        self.path(self.chain(pieces) + " Z", fill=fill, stroke="none")

    def chain(self, pieces):
        last = pieces[0]
        data = "M " + self.at(last)
        for piece in pieces[1:]:
            if isinstance(piece, Vector):
                data += " L " + self.at(piece)
                last = piece
            else:
                center, end = piece
                data += " " + self.arc_data(center, last, end)
                last = end
        return data

    def arrow(self, a, b, color, width=1.5, head=9):
        tip, u = b, (b - a).unit()
        size = head / self.scale
        self.line([a, b - u * (0.8 * size)], color, width)
        self.polygon([tip, tip - u * size + u.left() * (0.36 * size), tip - u * size - u.left() * (0.36 * size)], color)

    def dot(self, p, color, radius=4, stroke="white"):
        x, y = self.at(p).split()
        self.parts.append('<circle cx="%s" cy="%s" r="%g" fill="%s" stroke="%s" stroke-width="%g"/>'
                          % (x, y, radius, color, stroke, 1 if stroke == "white" else 2))

    def right_angle(self, p, along, across, color):
        size = 9 / self.scale
        self.line([p + along * size, p + along * size + across * size, p + across * size], color, 1)

    def label(self, p, text, shift=(0, 0), anchor="middle", color=INK, size=15):
        """Text; *x* is a variable, and x_1 has an index."""
        x, y = ((p[0] - self.low[0]) * self.scale + shift[0], (self.high[1] - p[1]) * self.scale + shift[1])
        self.parts.append('<text x="%.1f" y="%.1f" text-anchor="%s" fill="%s" font-size="%d">%s</text>'
                          % (x, y, anchor, color, size, self.markup(text, size)))

    @staticmethod
    def markup(text, size):
        result = ""
        for number, part in enumerate(text.split("*")):
            if number % 2 == 0:
                result += part
                continue
            name, _, index = part.partition("_")
            result += ('<tspan font-family="Times New Roman, Liberation Serif, serif" font-style="italic" font-size="%d">%s</tspan>'
                       % (size + 2, name))
            if index:
                result += '<tspan font-size="%d" dy="4">%s</tspan><tspan dy="-4">&#8203;</tspan>' % (size - 4, index)
        return result

    def write(self, path, title):
        width, height = ((self.high[i] - self.low[i]) * self.scale for i in (0, 1))
        with open(path, "w", encoding="utf-8") as file:
            file.write('<svg xmlns="http://www.w3.org/2000/svg" width="%.0f" height="%.0f" viewBox="0 0 %.0f %.0f" '
                       'font-family="Helvetica, Arial, Liberation Sans, sans-serif">\n' % (width, height, width, height))
            file.write("<title>%s</title>\n" % title)
            file.write('<rect width="100%" height="100%" fill="white"/>\n')
            file.write("\n".join(self.parts) + "\n</svg>\n")


def window(folder):
    """A window on a halfedge, with a pseudo-source as image, and its two children."""
    d = Drawing(Vector(-1.35, -3.75), Vector(6.1, 4.0), 84)
    origin, end, apex = Vector(0, 0), Vector(5.6, 0), Vector(2.2, 3.5)
    side = Vector(4.9, -1.5)  # a vertex of the face below the halfedge
    image, b0, b1 = Vector(2.1, -2.9), Vector(1.25, 0), Vector(3.7, 0)

    d.polygon([origin, end, side], "#fafaf8", EDGE)
    d.polygon([origin, side, image], "#fafaf8", EDGE)
    d.polygon([origin, end, apex], FACE, EDGE)
    left = line_meets_line(image, b0 - image, origin, apex)
    right = line_meets_line(image, b1 - image, end, apex)
    d.polygon([image, b0, b1], "#eef4fb")
    split = line_meets_line(image, apex - image, origin, end)
    d.polygon([b0, split, apex, left], BLUE)
    d.polygon([split, b1, right, apex], GREEN)
    for face in ([origin, end, apex], [origin, end, side], [origin, side, image]):
        d.polygon(face, "none", EDGE)
    d.line([image, left], RAY)
    d.line([image, right], RAY)
    d.line([image, apex], RAY, 1.3, "5 4")
    d.line([left, apex], "#3f7fbf", 5)
    d.line([right, apex], "#57a55a", 5)

    # the halfedge, its frame and the interval
    d.arrow(origin, end, INK, 2, 12)
    d.arrow(origin, origin + Vector(0, 1.15), INK, 1.3, 9)
    d.label(origin + Vector(0, 1.15), "*y*", (-10, 6))
    d.label(end, "*x*", (12, 5))
    d.label((b1 + end) * 0.5, "halfedge", (0, -8))
    d.line([b0, b1], SOURCE, 5)
    d.label(b0, "*b_0*", (-14, 20))
    d.label(b1, "*b_1*", (18, 19))
    d.label(origin, "origin", (-8, 5), "end")
    d.label(apex, "apex", (0, -12))

    # a point and its path
    p = Vector(1.7, 1.75)
    d.line([image, p], SOURCE, 1.6)
    d.dot(p, INK)
    d.label(p, "*p*", (-11, -3))
    d.label(Vector(-1.15, 3.0), "*D*(*p*) = *&#963;* + |*p* &#8722; *q*|", (0, 0), "start")

    # the image and the way from the source
    source = Vector(-0.75, -3.15)
    bend = Vector(0.75, -3.3)
    d.line([source, bend, image], SOURCE, 1.6, "2 5")
    d.dot(source, SOURCE)
    d.dot(image, SOURCE, 5)
    d.label(source, "source", (0, -12))
    d.label(bend, "*&#963;*", (6, 20))
    d.label(image, "image *q*", (12, 16), "start")
    height = -1.8
    d.label(line_meets_line(image, b1 - image, Vector(0, height), Vector(1, height)), "bounding ray", (7, 5), "start", RAY)
    d.label((left + apex) * 0.5, "child", (-12, -4), "end", "#2f6ca8")
    d.label((right + apex) * 0.5, "child", (12, -6), "start", "#3c8a40")
    d.write(os.path.join(folder, "window.svg"), "A window on a halfedge")


def offset_in_face(folder):
    """An offset in one face: the fronts of a point, of a pseudo-source, and of a source segment."""
    d = Drawing(Vector(-1.7, -2.1), Vector(9.4, 7.4), 68)
    a, b, c = Vector(0, 0), Vector(8.2, 0), Vector(1.2, 7.0)
    q = Vector(-1.3, -1.6)  # the image of a source point; a is a pseudo-source behind it
    end, along = Vector(7.5, 5.0), Vector(0.3, -0.95).unit()  # the image of a source segment
    other = end + along * 5.0
    normal = along.left() * -1  # into the face
    level = 5.35
    sigma = (a - q).length()

    # the offset
    first = c * ((level - sigma) / c.length())
    smooth = a + (a - q).unit() * (level - sigma)
    foot = end + normal * level
    corner = line_meets_circle(foot, along, q, level)[0]
    assert (corner - end).dot(along) > 0, "the corner is not in front of the segment"
    last = line_meets_circle(c, b - c, end, level)[0]
    offset = [first, (a, smooth), (q, corner), foot, (end, last)]

    # the parts of the face that are nearer than the level, by the kind of their nearest point; the front of q ends where
    # that of the segment is as near, on a parabola
    def bisector(s):
        """Point at the coordinate s along the segment that is as far from q as from the segment."""
        height, along_q = (q - end).dot(normal), (q - end).dot(along)
        return end + along * s + normal * ((height ** 2 + (s - along_q) ** 2) / (2 * height))

    low, high = (corner - end).dot(along), 12.0
    for _ in range(60):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if bisector(middle)[1] > 0 else (low, middle)
    parabola = [bisector((corner - end).dot(along) + (low - (corner - end).dot(along)) * i / 40) for i in range(41)]
    normal_end = line_meets_line(end, normal, b, c)
    d.polygon([a, b, c], FACE)
    d.region([a, first, (a, smooth)], ORANGE)
    d.region([a, smooth, (q, corner)] + parabola, BLUE)
    d.region([corner, foot, normal_end, b] + parabola[::-1], GREEN)
    d.region([normal_end, foot, (end, last)], VIOLET)
    d.polygon([a, b, c], "none", EDGE)

    # the sources and their rays
    d.line([q, a], SOURCE, 1.6)
    d.line([end, other], SOURCE, 3)
    d.line([a, smooth + (smooth - a).unit() * 0.45], RAY, 1.4, "5 4")
    d.line([end, foot + normal * 0.45], RAY, 1.4, "5 4")
    d.right_angle(end, along, normal, RAY)
    d.line(parabola, INK, 1.2, "1.5 4")
    d.curve(offset, OFFSET, 2.8)
    for p in (smooth, foot):
        d.dot(p, "white", 4.5, INK)
    d.dot(corner, INK, 4.5)
    d.dot(q, SOURCE, 5)
    d.dot(a, SOURCE, 5)
    d.dot(end, SOURCE, 5)
    d.label(q, "image *q* of a source point", (12, 5), "start")
    d.label(a, "pseudo-source *v*", (10, 21), "start")
    d.label(end, "*e*", (4, -11))
    d.label((end + other) * 0.5, "source segment", (-12, 5), "end")
    d.label(a + (smooth - a) * 0.36, "bounding ray", (10, 10), "start", RAY)
    d.label(normal_end + (end - normal_end) * 0.5, "normal at *e*", (-14, -14), "middle", RAY)
    legend = Vector(6.0, -1.05)
    d.dot(legend, "white", 4.5, INK)
    d.label(legend, "smooth joint", (13, 5), "start")
    d.dot(legend - Vector(0, 0.4), INK, 4.5)
    d.label(legend - Vector(0, 0.4), "corner", (13, 5), "start")
    d.label(Vector(1.17, 2.48), "*&#963;* + |*p* &#8722; *v*|")
    d.label(Vector(2.55, 0.42), "|*p* &#8722; *q*|")
    d.label(Vector(5.2, 1.1), "distance of *p* from the line")
    d.label(Vector(3.0, 4.3), "|*p* &#8722; *e*|")
    d.label(Vector(1.5, 4.9), "*D*(*p*) &gt; *d*")
    d.write(os.path.join(folder, "offset_in_face.svg"), "An offset in a face")


def polyline_windows(folder):
    """The windows that a polyline sends in a plane, and its offset."""
    d = Drawing(Vector(-2.9, -2.35), Vector(8.1, 5.2), 72)
    a, b, c = Vector(0, 0), Vector(4.2, 1.2), Vector(5.3, 4.4)  # the polyline turns left at b and continues behind c
    level, reach = 1.35, 2.1
    u, v = (b - a).unit(), (c - b).unit()
    n, m = u.left(), v.left()

    # on the left, the fronts of both segments meet on the bisector of the angle
    across = (n + m).unit()
    meeting = b + across * (reach / across.dot(n))
    d.region([a, a + n * reach, meeting, b], BLUE)
    d.region([b, meeting, c + m * reach, c], GREEN)
    # on the right, an interval window of the corner lies between the parallel-source windows
    d.region([a, a - n * reach, b - n * reach, b], BLUE)
    d.region([b, b - m * reach, c - m * reach, c], GREEN)
    d.region([b, b - n * reach, (b, b - m * reach)], ORANGE)
    d.region([a, a + n * reach, (a, a - u * reach), (a, a - n * reach)], ORANGE)

    # rays, on the left up to the bisector
    for i in range(1, 8):
        p, s = b - (b - a) * (i / 8), b + (c - b) * (i / 8)
        slope = (meeting - b).dot(n) / (b - meeting).dot(u)
        for start, normal, color in ((p, n, RAY), (s, m, "#3c8a40")):
            d.arrow(start, start - normal * (reach - 0.05), color, 0.8, 6)
            d.arrow(start, start + normal * (min(reach, (start - b).length() * slope) - 0.05), color, 0.8, 6)
    corner_angle = math.atan2((n * -1).cross(m * -1), n.dot(m))
    for center, first, angle, number in ((b, n * -1, corner_angle, 4), (a, n, math.pi, 11)):
        for i in range(1, number):
            turn = angle * i / number
            ray = first * math.cos(turn) + first.left() * math.sin(turn)
            d.arrow(center, center + ray * (reach - 0.05), "#b9791f", 0.8, 6)

    d.line([b, meeting], INK, 1.2, "1.5 4")
    corner = b + across * (level / across.dot(n))
    d.curve([c - m * level, b - m * level, (b, b - n * level), a - n * level, (a, a - u * level), (a, a + n * level), corner,
             c + m * level], OFFSET, 2.8)
    d.line([a, b, c], SOURCE, 3)
    for p in (a, b):
        d.dot(p, SOURCE, 5)
    for p in (b - n * level, b - m * level, a - n * level, a + n * level):
        d.dot(p, "white", 4.5, INK)
    d.dot(corner, INK, 4.5)
    d.label(a - n * reach + (b - a) * 0.5, "parallel-source windows", (12, 14), "start", RAY)
    d.label(a + (n - u).unit() * reach, "interval windows", (-2, -70), "middle", "#96600f")
    d.label(b - (n + m).unit() * reach, "interval windows", (10, 12), "start", "#96600f")
    d.label(meeting, "equal distances", (-12, -6), "end")
    d.label(c, "source polyline", (4, -12), "start")
    d.write(os.path.join(folder, "polyline_windows.svg"), "The windows of a polyline")


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    window(sys.argv[1])
    offset_in_face(sys.argv[1])
    polyline_windows(sys.argv[1])


if __name__ == "__main__":
    main()
