import { t } from "../words/words";
import { useShown } from "./context";
import "./lost-link.css";

/** Says loudly that what is shown may be old. */
export function LostLink() {
  const status = useShown((shown) => shown.status);
  if (status !== "lost") return null;
  return (
    <div className="lost-link" role="alert">
      <strong>{t("No link to the machine.")}</strong>{" "}
      {t(
        "What is shown is old. A job goes on without this page; use the stop button at the machine.",
      )}
    </div>
  );
}
