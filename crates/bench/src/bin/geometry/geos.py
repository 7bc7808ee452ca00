"""Offsets by GEOS: reads lines of JSON, writes lines of JSON. Run by the geometry benchmark."""
import json
import sys
import time

import shapely
from shapely.geometry import MultiPolygon, Polygon

QUADRANT = 64  # chords a quarter circle: 8e-5 of the radius


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
    true = Polygon(case["contours"][0]).buffer(case["distance"], quad_segs=QUADRANT)
    ours = region(case["rings"])
    apart = 0.0
    if not (true.is_empty or ours.is_empty):
        apart = shapely.hausdorff_distance(true, ours)
    thick, wrong = False, abs(true.area - ours.area)
    if apart > case["allowed"] or true.is_empty != ours.is_empty:
        # A hair that one of them has is no error; what an inward offset of the difference leaves is.
        difference = true.symmetric_difference(ours)
        wrong = difference.area
        thick = not difference.buffer(-case["allowed"] / 2).is_empty
    return {"area": true.area, "wrong": wrong, "thick": thick, "distance": apart}


for line in sys.stdin:
    case = json.loads(line)
    print(json.dumps(timed(case) if case["do"] == "time" else compared(case)), flush=True)
