import { useSyncExternalStore } from "react";
import { t } from "../words/words";
import { takesText } from "./typing";

const listen = (changed: () => void) => {
  // The focus has left the one before it has come to the next.
  const look = () => queueMicrotask(changed);
  addEventListener("focusin", look);
  addEventListener("focusout", look);
  return () => {
    removeEventListener("focusin", look);
    removeEventListener("focusout", look);
  };
};

const isTyping = () => takesText(document.activeElement);

/** Says at STOP that the space bar is none while a field of text has the focus. */
export function SpaceTypes() {
  const typing = useSyncExternalStore(listen, isTyping);
  if (!typing) return null;
  return (
    <p
      className="space-types"
      title={t("Space types here: press Escape first, then Space is STOP")}
    >
      {t("Space types: Esc first")}
    </p>
  );
}
