import { t } from "../words/words";
import { useSnapshot } from "./context";
import "./together.css";

/** The machines that are served together, above all else: this page is that of one, and its STOP stops that one. */
export function Together() {
  const machines = useSnapshot("together") ?? [];
  if (machines.length < 2) return null;
  return (
    <nav className="together" aria-label={t("Machines")}>
      {machines.map(({ name, port, here }) =>
        here ? (
          <span key={port} className="together-here" aria-current="page">
            {name}
          </span>
        ) : (
          <a key={port} href={pageOf(port)} title={t("The page of {0}", name)}>
            {name}
          </a>
        ),
      )}
    </nav>
  );
}

/** A page at another port of the same host. */
function pageOf(port: number): string {
  const page = new URL("/", location.href);
  page.port = String(port);
  return page.href;
}
