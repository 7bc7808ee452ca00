import { describe, expect, it } from "vitest";
import {
  type Around,
  chosen,
  type DeskState,
  type Done,
  dragged,
  escaped,
  firstDesk,
  moved,
  pressed,
  released,
  rightClicked,
  startTool,
} from "./desk";
import { boxOf, place } from "./geometry/vec";
import { typed } from "./keys";
import { pickingOf } from "./pick";
import { rectangle, tool } from "./testing";

const a = rectangle(1, 0, 0, 50, 30);
const b = rectangle(2, 200, 100, 260, 140);
const around = (selected: readonly number[] = []): Around => ({
  picking: pickingOf([a, b]),
  picked: [],
  selected,
  box: boxOf(place(0, 0), place(260, 140)),
  pickRadius: 8,
  expansion: 1.05,
  lastJoin: 0.1,
});

const click = (state: DeskState, x: number, y: number, world = around(), adds = false): Done =>
  drag(state, [x, y], [x, y], world, adds);

const drag = (
  state: DeskState,
  from: [number, number],
  to: [number, number],
  world = around(),
  adds = false,
): Done => {
  const over = moved(pressed(state, place(...from), world), place(...to), place(0, 0));
  return dragged(released(over), over.drag, adds, world);
};

const key = (state: DeskState, name: string) => typed(state, name, around())?.state ?? state;

describe("the drawing desk without a tool", () => {
  it("selects within 8 pixels of an edge", () => {
    expect(click(firstDesk, 57.9, 15).clauses).toBe("select 1");
    expect(click(firstDesk, 58.1, 15).clauses).toBeUndefined();
    expect(click(firstDesk, 58.1, 15, around([1])).clauses).toBe("select none");
  });

  it("adds and takes out with Shift", () => {
    expect(click(firstDesk, 200, 120, around([1]), true).clauses).toBe("select add 2");
    expect(click(firstDesk, 50, 15, around([1]), true).clauses).toBe("select remove 1");
  });

  it("selects by a window from the left, by crossing from the right", () => {
    expect(drag(firstDesk, [-1, -1], [220, 150]).clauses).toBe("select window -1,-1 220,150");
    expect(drag(firstDesk, [220, 150], [-1, -1]).clauses).toBe("select crossing 220,150 -1,-1");
  });

  it("pro_select_chooser: lets choose between shapes on each other", () => {
    const two = { ...around(), picking: pickingOf([a, { ...a, number: 2, group: "red" }]) };
    const { state, clauses } = click(firstDesk, 50, 15, two);
    expect(clauses).toBeUndefined();
    expect(state.chooser?.numbers).toEqual([1, 2]);
    expect(chosen(state, 2, place(50, 15), false, two).clauses).toBe("select 2");
    expect(escaped(state, two).state.chooser).toBeNull();
  });

  it("pro_select_rmb_repeat: does the last tool again with the right button, and nothing before the first", () => {
    expect(rightClicked(firstDesk, around()).state.running).toBeNull();
    const after = escaped(startTool(firstDesk, tool("move"), around()).state, around()).state;
    expect(rightClicked(after, around()).state.running?.tool.id).toBe("move");
  });
});

describe("a tool on the drawing desk", () => {
  it("pro_snap_move_example: places a corner exactly on another by two snaps", () => {
    let { state } = startTool(firstDesk, tool("move"), around());
    ({ state } = click(state, 25, 0));
    ({ state } = rightClicked(state, around()));
    ({ state } = click(key(state, "v"), 2, 3));
    expect(state.running?.snap).toBeNull();
    const { clauses } = click(key(state, "v"), 258, 141);
    expect(clauses).toBe("select 1; move from 0,0 to 260,140");
  });

  it("keeps the click that went down while the tool waited for its turn", () => {
    const down = pressed(firstDesk, place(10, 20), around());
    const { state } = startTool(down, tool("point"), around());
    expect(dragged(released(state), state.drag, false, around()).clauses).toMatch(/^point 10,20/);
  });

  it("stays open when a snap finds nothing", () => {
    const { state } = startTool(firstDesk, tool("point"), around());
    const done = click(key(state, "v"), 120, 60);
    expect(done.words).toMatch(/no vertex/);
    expect(done.state.running?.tool.id).toBe("point");
  });

  it("pro_snap_none: turns the snap off with Q", () => {
    const { state } = startTool(firstDesk, tool("point"), around());
    expect(click(key(key(state, "v"), "q"), 2, 3).clauses).toBe("point 2,3");
  });

  it("turns what is moved with the arrow keys, by the step that is kept", () => {
    let { state } = startTool(firstDesk, tool("move"), around([1]));
    state = key(key(key(state, "arrowup"), "arrowup"), "arrowleft");
    expect(state.running?.turned).toBe(4);
    ({ state } = click(state, 0, 0, around([1])));
    const done = click(state, 10, 0, around([1]));
    expect(done.clauses).toBe("select 1; move from 0,0 to 10,0; rotate 4 about 10,0");
    expect(done.state.turnStep).toBe(4);
  });

  it("takes regions as shapes", () => {
    const { state } = startTool(firstDesk, tool("erase"), around());
    expect(drag(state, [-1, -1], [220, 150]).state.running?.picked).toEqual([1]);
    expect(drag(state, [220, 150], [-1, -1]).state.running?.picked).toEqual([1, 2]);
  });

  it("pro_edit_type_key: asks for numbers that only can be typed, and opens the entry with T or a digit", () => {
    expect(startTool(firstDesk, tool("fillet"), around()).state.entry).toBe("5");
    const { state } = startTool(firstDesk, tool("circle"), around());
    expect(key(state, "t").entry).toBe("");
    expect(key(state, "5").entry).toBe("5");
  });

  it("is given up with Escape", () => {
    const { state } = startTool(firstDesk, tool("stretch"), around([1]));
    expect(escaped(state, around([1])).state.running).toBeNull();
  });

  it("pro_snap_zoom_in: zooms and pans in the middle of a tool", () => {
    const { state } = startTool(
      { ...firstDesk, size: { width: 200, height: 150 } },
      tool("line"),
      around(),
    );
    const at = moved(state, place(30, 40), place(0, 0));
    expect(key(at, "z").window).toEqual({ middle: place(30, 40), mmPerPixel: 0.5 });
    expect(key(at, "x").window.mmPerPixel).toBe(2);
    expect(key(at, "s").window).toEqual({ middle: place(30, 40), mmPerPixel: 1 });
    expect(key(at, "a").window.middle).toEqual(place(130, 70));
    expect(key(at, "z").running).toBe(state.running);
  });
});
