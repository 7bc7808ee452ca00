/** The simulation of a tool path as a film: played, held, wound to a place, slowed or hastened. */

export interface Playback {
  /** Planned time that is shown, seconds; nothing shows what the machine does. */
  readonly at: number | null;
  readonly playing: boolean;
  /** Planned seconds in a second. */
  readonly speed: number;
}

export const live: Playback = { at: null, playing: false, speed: 4 };

export const speeds = [0.25, 1, 4, 16, 64] as const;

/** Starts or holds; a film that is over begins anew. */
export function toggled(playback: Playback, seconds: number): Playback {
  const over = playback.at === null || playback.at >= seconds;
  return { ...playback, at: over ? 0 : playback.at, playing: over || !playback.playing };
}

/** Winds to a place and stands there. */
export const wound = (playback: Playback, at: number): Playback => ({
  ...playback,
  at,
  playing: false,
});

/** Time went by. */
export function passed(playback: Playback, realSeconds: number, seconds: number): Playback {
  if (!playback.playing || playback.at === null) return playback;
  const at = Math.min(playback.at + realSeconds * playback.speed, seconds);
  return { ...playback, at, playing: at < seconds };
}
