import { t } from "../words/words";
import { type Route, routes } from "./routes";

/** A screen that is not there yet. */
export function ComingScreen({ route }: { route: Route }) {
  const title = routes.find(({ path }) => path === route)?.title;
  return (
    <div className="coming">
      <h1>{title}</h1>
      <p>{t("This screen is not part of this version yet.")}</p>
    </div>
  );
}
