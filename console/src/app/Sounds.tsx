import { useEffect, useRef } from "react";
import { soundAddress } from "../link/http";
import { t } from "../words/words";
import { useHands, useSnapshot } from "./context";

/** Plays what a program plays (PLAY), each sound once; what was played before this page came stays unheard. */
export function Sounds() {
  const { screen } = useHands();
  const sound = useSnapshot("sound");
  const heard = useRef<number>(undefined);
  const player = useRef<HTMLAudioElement>(null);
  useEffect(() => {
    if (sound === undefined) return;
    const before = heard.current;
    heard.current = sound?.number ?? 0;
    if (before === undefined || !sound || !player.current || before === sound.number) return;
    player.current.src = soundAddress(sound.name);
    player.current.play().catch((error: unknown) => {
      if (error instanceof DOMException && error.name === "NotAllowedError") {
        screen.tell(
          t("A sound was played. This browser lets it be heard after a click on the page."),
        );
      }
    });
  }, [sound, screen]);
  // biome-ignore lint/a11y/useMediaCaption: what a program plays is a signal, without words
  return <audio ref={player} />;
}
