import { useSnapshot } from "../app/context";
import { t } from "../words/words";
import "./pause-card.css";

/** A pause of so many seconds: what the program says to it, and how long it still is. Nobody has to press. */
export function PauseCard() {
  const pause = useSnapshot("pause");
  const now = useSnapshot("motion")?.t ?? 0;
  const left = pause ? Math.ceil(pause.until - now) : 0;
  // What is over at once is not worth a word.
  if (!pause || (pause.text === "" && left < 1)) return null;
  return (
    <section className="pause-card" role="status" aria-label={t("Pause")}>
      <p className="pause-text">{pause.text || t("Pause")}</p>
      <p className="pause-left">
        {t("Goes on by itself in")} <b>{Math.max(0, left)}</b> s
      </p>
    </section>
  );
}
