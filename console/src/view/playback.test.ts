import { describe, expect, it } from "vitest";
import { live, passed, toggled, wound } from "./playback";

describe("the film of a tool path", () => {
  it("plays to its end and begins anew", () => {
    const playing = toggled({ ...live, speed: 2 }, 10);
    expect(playing).toMatchObject({ at: 0, playing: true });
    const later = passed(playing, 3, 10);
    expect(later.at).toBe(6);
    const over = passed(later, 30, 10);
    expect(over).toMatchObject({ at: 10, playing: false });
    expect(toggled(over, 10)).toMatchObject({ at: 0, playing: true });
  });

  it("is held and goes on where it was", () => {
    const held = toggled(passed(toggled(live, 100), 1, 100), 100);
    expect(held).toMatchObject({ at: 4, playing: false });
    expect(passed(held, 5, 100)).toBe(held);
    expect(toggled(held, 100)).toMatchObject({ at: 4, playing: true });
  });

  it("stands where it is wound to", () =>
    expect(wound(toggled(live, 100), 42)).toMatchObject({ at: 42, playing: false }));
});
