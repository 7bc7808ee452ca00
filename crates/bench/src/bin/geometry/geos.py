"""Offsets by GEOS: reads lines of JSON, writes lines of JSON. Run by the geometry benchmark."""
import json
import math
import sys
import time

import shapely
from shapely.geometry import MultiPolygon, Polygon

QUADRANT = 64  # chords a quarter circle: 8e-5 of the radius
PLACES = 8  # where engines differ, so many places across each way are decided


def region(rings):
    """Counter-clockwise rings are outlines, clockwise ones holes."""
    shells = [Polygon(r) for r in rings if shapely.LinearRing(r).is_ccw]
    holes = [Polygon(r) for r in rings if not shapely.LinearRing(r).is_ccw]
    whole = shapely.union_all(shells) if shells else MultiPolygon()
    return whole.difference(shapely.union_all(holes)) if holes else whole


def timed(case):
    polygons = [Polygon(c) for c in case["contours"]]
    least = None
    for _ in range(7):
        begun = time.thread_time()
        # Round joins at a micrometre, as the others.
        found = [p.buffer(case["distance"], quad_segs=case["quadrant"]) for p in polygons]
        took = time.thread_time() - begun
        least = took if least is None else min(least, took)
    off = max(deviation(p, f, abs(case["distance"])) for p, f in zip(polygons, found))
    parts = [g for f in found for g in getattr(f, "geoms", [f]) if not g.is_empty]
    return {
        "ms": least * 1e3,
        "rings": sum(1 + len(p.interiors) for p in parts),
        "vertices": int(sum(shapely.get_num_coordinates(p) for p in parts)),
        "area": sum(p.area for p in parts),
        "deviation": off,
    }


def deviation(polygon, found, distance):
    """How far corners and middles of chords are from their distance, at the most."""
    if found.is_empty:
        return 0.0
    worst = 0.0
    for ring in shapely.get_rings(found):
        corners = shapely.get_coordinates(ring)
        places = shapely.points([*corners, *((corners[1:] + corners[:-1]) / 2)])
        off = abs(shapely.distance(places, polygon.exterior) - distance).max()
        worst = max(worst, float(off))
    return worst


def compared(case):
    shape = Polygon(case["contours"][0])
    theirs = shape.buffer(case["distance"], quad_segs=QUADRANT)
    ours = region(case["rings"])
    apart = 0.0
    if not (theirs.is_empty or ours.is_empty):
        apart = shapely.hausdorff_distance(theirs, ours)
    wrong, decided = abs(theirs.area - ours.area), []
    if apart > case["allowed"] or theirs.is_empty != ours.is_empty:
        # A hair that one of them has is no error; what an inward offset of the difference leaves is.
        difference = theirs.symmetric_difference(ours)
        wrong = difference.area
        thick = difference.buffer(-case["allowed"] / 2)
        decided = [judged(case, shape, ours, at) for at in places_in(thick)]
    return {"area": theirs.area, "wrong": wrong, "distance": apart, "decided": decided}


def places_in(area):
    """A place of each part and a grid over it."""
    for part in getattr(area, "geoms", [area]):
        if part.is_empty:
            continue
        yield part.representative_point()
        left, low, right, high = part.bounds
        shares = [(k + 0.5) / PLACES for k in range(PLACES)]
        grid = [(left + (right - left) * u, low + (high - low) * v) for u in shares for v in shares]
        yield from (at for at in shapely.points(grid) if part.contains(at))


def judged(case, shape, ours, at):
    """Who is right about a place, by its distance to the lines and arcs themselves: the definition of an offset."""
    size, outward = abs(case["distance"]), case["distance"] > 0
    far, inside = distance((at.x, at.y), case["vertices"]), shape.contains(at)
    held = inside or far <= size if outward else inside and far >= size
    by = "Kerf" if held == ours.contains(at) else "GEOS"
    # A place whose distance is the offset all but for the sag of chords is decided by these.
    sag = case["chord"] + size * (1.0 - math.cos(math.pi / (4 * QUADRANT)))
    return {"right": "both" if abs(far - size) <= sag else by, "at": [at.x, at.y], "far": far}


def distance(at, vertices):
    following = [*vertices[1:], vertices[0]]
    return min(distance_to(at, [x, y], [u, v], bulge) for (x, y, bulge), (u, v, _) in zip(vertices, following))


def distance_to(at, start, end, bulge):
    """To a line, or an arc whose bulge is the tangent of a quarter of its angle."""
    along = [end[0] - start[0], end[1] - start[1]]
    to, long = [at[0] - start[0], at[1] - start[1]], math.hypot(*along)
    ends = min(math.dist(at, start), math.dist(at, end))
    if bulge == 0.0:
        reach = to[0] * along[0] + to[1] * along[1]
        off = abs(to[0] * along[1] - to[1] * along[0]) / long
        return off if 0.0 < reach < long * long else ends
    high = (1.0 - bulge * bulge) / (4.0 * bulge)
    centre = [(start[0] + end[0]) / 2 - high * along[1], (start[1] + end[1]) / 2 + high * along[0]]
    turn = math.atan2(at[1] - centre[1], at[0] - centre[0]) - math.atan2(start[1] - centre[1], start[0] - centre[0])
    faces = (turn * math.copysign(1.0, bulge)) % math.tau < 4.0 * math.atan(abs(bulge))
    return min(ends, abs(math.dist(at, centre) - math.dist(start, centre))) if faces else ends


for line in sys.stdin:
    case = json.loads(line)
    print(json.dumps(timed(case) if case["do"] == "time" else compared(case)), flush=True)
