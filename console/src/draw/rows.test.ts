/** Rows of the Profiler reference about drawing by hand, with its numbers. 1 mm is 1 pixel. */

import { describe, expect, it } from "vitest";
import { hueOf } from "./colours";
import { choices } from "./desk";
import { crossesItself } from "./geometry/crossing";
import { place } from "./geometry/vec";
import { overlayOf } from "./ghost";
import { coloursOf } from "./inks";
import { squareInk } from "./paint/overlay";
import { promptOf } from "./prompt";
import { Hand, path, rectangle } from "./testing";
import { tools } from "./tools/catalog";
import { boxInSight, fitted } from "./window";

const square = rectangle(1, 0, 0, 100, 100);
const small = rectangle(1, 0, 0, 10, 10);
const far = rectangle(2, 40, 0, 60, 20);

describe("selecting", () => {
  it("pro_select_window: takes what is wholly inside a region begun at its left", () => {
    expect(new Hand([small, far]).begin("erase").drag(-1, -1, 50, 30).right().clauses).toEqual([
      "select 1; erase",
    ]);
  });

  it("pro_select_crossing: takes what a region begun at its right touches, not what surrounds it", () => {
    expect(new Hand([small, far]).begin("erase").drag(50, -1, -1, 30).right().clauses).toEqual([
      "select 1,2; erase",
    ]);
    expect(new Hand([square]).begin("erase").drag(60, 60, 40, 40).state.running?.picked).toEqual(
      [],
    );
  });

  it("pro_select_chooser_order: offers shapes in the cutting order", () => {
    const two = [{ ...square, number: 2, group: "red" }, square];
    expect(new Hand(two).click(50, 0).state.chooser?.numbers).toEqual([1, 2]);
  });

  it("pro_select_chooser_cancel: Esc selects nothing and the tool goes on", () => {
    const two = [square, { ...square, number: 2, group: "red" }];
    const hand = new Hand(two).begin("erase").click(50, 0).escape();
    expect(hand.state.chooser).toBeNull();
    expect(hand.state.running?.picked).toEqual([]);
    expect(hand.clauses).toEqual([]);
  });

  it("picks in cutting order carry their numbers; picked again, a shape loses its own", () => {
    const third = rectangle(3, 80, 0, 90, 20);
    const hand = new Hand([small, far, third]).begin("sequence");
    const numbers = (now: Hand) => {
      const { picked, numbered } = overlayOf(now.state, now.around);
      return numbered ? picked.map(({ number }) => number) : undefined;
    };
    expect(numbers(hand.click(80, 5).click(10, 5).click(40, 5))).toEqual([3, 1, 2]);
    expect(numbers(hand.click(10, 5))).toEqual([3, 2]);
    expect(hand.right().clauses).toEqual(["sequence 3,2"]);
    // Where the order means nothing, no numbers are drawn.
    expect(numbers(new Hand([small, far]).begin("erase").click(10, 5))).toBeUndefined();
  });

  it("pro_select_rmb_finish: the right button ends the picking of shapes", () => {
    const hand = new Hand([small, far]).begin("move").click(10, 5).click(40, 5).right();
    expect(hand.state.running?.answers).toEqual([{ kind: "shapes", numbers: [1, 2] }]);
  });

  it("pro_select_rmb_cancel: the right button cancels what a left click would complete", () => {
    const hand = new Hand([small], [1]).begin("move").click(0, 0).right();
    expect(hand.state.running).toBeNull();
    expect(hand.clauses).toEqual([]);
  });

  it("pro_select_escape: Esc at any step of any tool changes nothing", () => {
    for (const { id, asks } of tools.filter((tool) => tool.asks.length > 0)) {
      for (let step = 0; step < asks.length; step += 1) {
        const hand = new Hand([small]).begin(id);
        for (let n = 0; n < step; n += 1) hand.answer();
        const before = hand.clauses.length;
        hand.escape();
        expect([id, step, hand.state.running, hand.clauses.length]).toEqual([
          id,
          step,
          null,
          before,
        ]);
      }
    }
  });

  it("pro_snap_status: the line below lists the snaps of a place, G with a base, none for shapes", () => {
    const hand = new Hand([small]).begin("move");
    expect(promptOf(hand.state).keys).toBe("");
    hand.click(10, 5).right();
    expect(promptOf(hand.state).keys).toBe("VCMINQ");
    hand.click(0, 0);
    expect(promptOf(hand.state).keys).toBe("VCMINGQ");
  });
});

describe("what is seen of picking", () => {
  const overlay = (hand: Hand) => overlayOf(hand.state, hand.around);
  const over = [square, { ...square, number: 2, group: "red" }];

  it("pro_select_lmb_point: a left click gives a place", () => {
    expect(new Hand([]).begin("point").click(12, 34).clauses).toEqual(["point 12,34"]);
    const snapped = new Hand([square]).begin("point").keys("v").click(99, 98);
    expect(snapped.clauses).toEqual(["point 100,100"]);
  });

  it("pro_select_region: a drag is a region, drawn while it lasts", () => {
    const hand = new Hand([small]).press(0, 0).move(30, 20);
    expect(overlay(hand).region).toMatchObject({ from: place(0, 0), to: place(30, 20) });
    expect(overlay(hand.move(50, 40)).region).toMatchObject({ to: place(50, 40) });
    expect(hand.release().clauses).toEqual(["select window 0,0 50,40"]);
    expect(overlay(hand).region).toBeNull();
  });

  it("pro_select_region_zoom: a region can be what is seen", () => {
    const hand = new Hand([square]).begin("zoom-window").drag(0, 0, 50, 40);
    const size = { width: 200, height: 150 };
    const { min, max } = boxInSight(hand.state.window, size);
    expect(hand.state.window.middle).toEqual(place(25, 20));
    expect(max.x - min.x).toBeCloseTo((40 * 200) / 150, 9);
    expect(max.y - min.y).toBeCloseTo(40, 9);
    expect([hand.clauses, hand.state.running]).toEqual([[], null]);
  });

  it("pro_select_chooser_mark: shapes that are selected already are marked", () => {
    const marked = (hand: Hand) => choices(hand.state, hand.around);
    expect(marked(new Hand(over, [1]).click(50, 0))).toEqual([
      { number: 1, highlighted: true },
      { number: 2, highlighted: false },
    ]);
    const picking = new Hand(over).begin("erase").click(50, 0).choose(1).click(50, 0);
    expect(marked(picking)[0]).toEqual({ number: 1, highlighted: true });
    expect(picking.choose(1).state.running?.picked).toEqual([]);
  });

  it("pro_snap_ortho_cross: a blue cross-hair at the base point while picks are square to it", () => {
    const hand = new Hand([small], [1]).begin("move").click(10, 20);
    expect(overlay(hand).square).toBeNull();
    expect(overlay(hand.keys("g")).square).toEqual(place(10, 20));
    expect(new Set(coloursOf(squareInk))).toEqual(new Set(["blue"]));
    expect(overlay(hand.keys("q")).square).toBeNull();
    expect(overlay(hand.keys("g").click(40, 22)).square).toBeNull();
    expect(hand.clauses).toEqual(["select 1; move from 10,20 to 40,20"]);
  });

  it("pro_snap_radius_circle: the selection radius is drawn while a snap is armed", () => {
    const hand = new Hand([square], [1]).begin("move").move(30, 40);
    expect(overlay(hand).radius).toBeNull();
    expect(overlay(hand.keys("v"))).toMatchObject({ radius: 8, pointer: place(30, 40) });
    expect(overlay(hand.keys("q")).radius).toBeNull();
  });

  it("pro_edit_join_default: the distance used last is offered", () => {
    const hand = new Hand([small], [1]).begin("join");
    expect(hand.state.entry).toBe("0.7");
  });

  it("pro_options_radius: the radius is that of the options", () => {
    const picks = (radius: number, far: number) =>
      new Hand([square], [], radius).click(50, -far).clauses.length;
    expect([picks(8, 7.9), picks(8, 8.1), picks(12, 11.9)]).toEqual([1, 0, 1]);
  });
});

describe("windows", () => {
  const at = () => new Hand([square]).begin("line").move(30, 40);
  const size = { width: 200, height: 150 };
  const sight = (hand: Hand) => {
    const { min, max } = boxInSight(hand.state.window, size);
    return { wide: max.x - min.x, high: max.y - min.y, middle: hand.state.window.middle };
  };

  it("pro_snap_zoom_out: X doubles what is in sight, about the mouse", () => {
    expect(sight(at().keys("x"))).toEqual({ wide: 400, high: 300, middle: place(30, 40) });
  });

  it("pro_snap_pan: S centres on the mouse at the same size", () => {
    expect(sight(at().keys("s"))).toEqual({ wide: 200, high: 150, middle: place(30, 40) });
  });

  it("pro_snap_view_all: A shows all data with the expansion", () => {
    const { middle, high } = sight(at().keys("a"));
    expect([middle, high]).toEqual([place(50, 50), 105]);
  });

  it("pro_display_expansion: 5 % in all, or nothing", () => {
    const all = boxInSight(fitted(square.box, { width: 100, height: 100 }), {
      width: 100,
      height: 100,
    });
    expect([all.min.x, all.max.x]).toEqual([-2.5, 102.5]);
  });
});

describe("snaps of a tool", () => {
  it("pro_snap_oneshot: a snap lasts for one pick", () => {
    const hand = new Hand([square], [1]).begin("move").keys("v").click(98, 2);
    expect(hand.state.running?.snap).toBeNull();
    expect(hand.click(33, 44).clauses).toEqual(["select 1; move from 100,0 to 33,44"]);
  });

  it("pro_snap_rot_ccw: the left arrow turns anticlockwise by the step", () => {
    const hand = new Hand([square], [1]).begin("move").keys("arrowleft", "arrowleft", "arrowleft");
    expect(hand.click(0, 0).click(0, 0).clauses).toEqual([
      "select 1; move from 0,0 to 0,0; rotate 3 about 0,0",
    ]);
    const dropped = new Hand([square], [1]).begin("move").keys("arrowleft").escape();
    expect(dropped.clauses).toEqual([]);
  });

  it("pro_snap_rot_cw: the right arrow turns clockwise", () => {
    const hand = new Hand([square], [1]).begin("move").keys("arrowright");
    expect(hand.click(0, 0).click(5, 0).clauses).toEqual([
      "select 1; move from 0,0 to 5,0; rotate 359 about 5,0",
    ]);
  });

  it("pro_snap_rot_stepup: the up arrow takes the next larger step", () => {
    const hand = new Hand([square], [1]).begin("move");
    const steps = Array.from({ length: 10 }, () => hand.keys("arrowup").state.turnStep);
    expect(steps).toEqual([2, 4, 8, 15, 30, 45, 60, 75, 90, 90]);
  });

  it("pro_snap_rot_stepdown: the down arrow takes the next smaller step", () => {
    const hand = new Hand([square], [1]).begin("move");
    hand.state = { ...hand.state, turnStep: 90 };
    const steps = Array.from({ length: 10 }, () => hand.keys("arrowdown").state.turnStep);
    expect(steps).toEqual([75, 60, 45, 30, 15, 8, 4, 2, 1, 1]);
  });

  it("pro_snap_rot_stepinit: the step is one degree at first and is kept for the next tool", () => {
    const hand = new Hand([square], [1]).begin("move");
    expect(hand.state.turnStep).toBe(1);
    hand.keys("arrowup", "arrowup").escape().begin("copy");
    expect(hand.state.turnStep).toBe(4);
  });

  it("pro_snap_rot_multiples: from 15 degrees on only multiples of the step", () => {
    const hand = new Hand([square], [1]).begin("move").keys("arrowup", "arrowup", "arrowup");
    expect(hand.keys("arrowleft").state.running?.turned).toBe(8);
    expect(hand.keys("arrowup", "arrowleft").state.running?.turned).toBe(15);
    expect(hand.keys("arrowright").state.running?.turned).toBe(0);
  });

  it("pro_snap_rot_ops: only move, copy and paste are turned", () => {
    expect(tools.filter(({ turns }) => turns).map(({ id }) => id)).toEqual([
      "move",
      "copy",
      "paste",
    ]);
    expect(new Hand([square], [1]).begin("stretch").keys("arrowleft").state.running?.turned).toBe(
      0,
    );
    const paste = new Hand([]).begin("paste").keys(...Array(9).fill("arrowup"), "arrowleft");
    expect(paste.click(0, 0).clauses).toEqual(["paste 0,0; rotate 90 about 0,0"]);
  });
});

describe("drawing with the mouse", () => {
  const drawn = (id: string, ...places: readonly (readonly [number, number])[]) => {
    const hand = new Hand([square]).begin(id);
    for (const [x, y] of places) hand.click(x, y);
    return hand;
  };

  it("pro_draw_circle: centre, then a place on it", () => {
    expect(drawn("circle", [50, 50], [75, 50]).clauses).toEqual(["circle 50,50 25"]);
  });

  it("pro_draw_rect: two opposite corners", () => {
    expect(drawn("rectangle", [10, 10], [60, 40]).clauses).toEqual(["rect 10,10 60,40"]);
  });

  it("pro_draw_point: a place", () => {
    expect(drawn("point", [5, 5]).clauses).toEqual(["point 5,5"]);
  });

  it("pro_draw_line: places, then the right button", () => {
    expect(drawn("line", [0, 0], [10, 0], [10, 10]).right().clauses).toEqual([
      "line 0,0 10,0 10,10",
    ]);
  });

  it("pro_draw_poly_close: the start, snapped to, closes", () => {
    const shapes = [path(1, [0, 0, 0, -50, -50, 0])];
    const hand = new Hand(shapes).begin("line").keys("v").click(1, 1).click(100, 0).click(100, 100);
    expect(hand.keys("v").click(1, 1).clauses).toEqual(["line 0,0 100,0 100,100 close"]);
  });

  it("pro_draw_poly_open_rmb: the right button ends, and discards a single place", () => {
    expect(drawn("line", [0, 0], [10, 0]).right().clauses).toEqual(["line 0,0 10,0"]);
    const single = drawn("line", [0, 0]).right();
    expect([single.clauses, single.state.running]).toEqual([[], null]);
  });

  it("pro_draw_poly_open_snap: the last place again ends it open", () => {
    expect(drawn("line", [0, 0], [10, 0], [10, 0]).clauses).toEqual(["line 0,0 10,0"]);
  });

  it("pro_draw_arc: the bulge follows the mouse", () => {
    const bulge = (x: number, y: number) =>
      drawn("polyarc", [0, 0], [10, 0], [x, y]).state.running?.vertices[0]?.bulge;
    expect([bulge(5, -5), bulge(5, 2.5)]).toEqual([1, -0.5]);
    expect(bulge(5, 0)).toBeCloseTo(0);
  });

  it("pro_draw_arc_close: the start closes, with the bulge of the last segment", () => {
    const hand = drawn("polyarc", [25, 0], [-25, 0], [0, 25], [25, 0], [0, -25]);
    expect(hand.clauses).toEqual(["line 25,0,1 -25,0,1 close"]);
  });

  it("pro_draw_arc_open: the right button leaves it open, bulges kept", () => {
    expect(drawn("polyarc", [0, 0], [10, 0], [5, -5]).right().clauses).toEqual(["line 0,0,1 10,0"]);
  });

  it("pro_draw_snapping: a line begins exactly at a corner", () => {
    const hand = new Hand([square]).begin("line").keys("v").click(97, 103);
    expect(hand.state.running?.vertices[0]?.at).toEqual(place(100, 100));
  });

  it("pro_edit_bulge_drag: a segment is bent by the mouse", () => {
    const hand = new Hand([path(1, [0, 0, 0, 100, 0, 0])]).begin("bulge").click(50, 0);
    expect(hand.click(50, -25).clauses).toEqual(["bulge 1 50,0 0.5"]);
  });

  it("pro_layout_origin_mouse: the origin is picked, with a snap", () => {
    expect(new Hand([square]).begin("origin").keys("v").click(99, 98).clauses).toEqual([
      "origin 100,100",
    ]);
  });
});

describe("colours", () => {
  const bow = path(1, [0, 0, 0, 100, 100, 0, 100, 0, 0, 0, 100, 0], { closed: true });
  const reversed = path(1, [0, 0, 0, 0, 100, 0, 100, 100, 0, 100, 0, 0], { closed: true });
  const hue = (shape: typeof square, byGroup = false) =>
    hueOf(shape, byGroup, crossesItself(shape));

  it("pro_display_color_cw: clockwise is red", () => expect(hue(reversed)).toBe("clockwise"));
  it("pro_display_color_ccw: anticlockwise is blue", () =>
    expect(hue(square)).toBe("anticlockwise"));
  it("pro_display_color_open: open is green", () =>
    expect(hue(path(1, [0, 0, 0, 5, 5, 0]))).toBe("open"));
  it("pro_display_color_selfcross: crossing itself is magenta", () =>
    expect(hue(bow)).toBe("crossing"));
  it("pro_display_groupcolor: or all have the colours of their groups", () =>
    expect(hue({ ...square, group: "cyan" }, true)).toBe("group-cyan"));
});
