import { useEffect, useState } from "react";
import { live, type Playback, passed } from "./playback";

/** The film of a path of so many seconds; another path stands at its beginning. */
export function usePlayback(seconds: number) {
  const [playback, setPlayback] = useState<Playback>(live);
  // biome-ignore lint/correctness/useExhaustiveDependencies: another length is another path
  useEffect(() => setPlayback(live), [seconds]);
  useEffect(() => {
    if (!playback.playing) return;
    let before = performance.now();
    let frame = 0;
    const tick = (now: number) => {
      const went = (now - before) / 1000;
      before = now;
      setPlayback((film) => passed(film, went, seconds));
      frame = requestAnimationFrame(tick);
    };
    frame = requestAnimationFrame(tick);
    return () => cancelAnimationFrame(frame);
  }, [playback.playing, seconds]);
  return [playback, setPlayback] as const;
}
