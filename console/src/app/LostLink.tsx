import { useShown } from "./context";
import "./lost-link.css";

/** Says loudly that what is shown may be old. */
export function LostLink() {
  const status = useShown((shown) => shown.status);
  if (status !== "lost") return null;
  return (
    <div className="lost-link" role="alert">
      <strong>No link to the machine.</strong> What is shown is old. A job goes on without this
      page; use the stop button at the machine.
    </div>
  );
}
