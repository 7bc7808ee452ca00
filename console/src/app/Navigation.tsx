import { openPalette } from "../actions/go";
import { ActionButton } from "../ui/ActionButton";
import { t } from "../words/words";
import { useHands, useScreen, useSnapshot } from "./context";
import { routes, shownIn } from "./routes";
import "./navigation.css";

export function Navigation() {
  const { screen } = useHands();
  const drawingOnly = useSnapshot("drawingOnly") ?? false;
  const here = shownIn(useScreen("route"), drawingOnly);
  return (
    <nav className="nav" aria-label={t("Screens")}>
      <img className="nav-mark" src="/kerf.svg" alt="Kerf" width="28" height="28" />
      {routes
        .filter(({ path }) => shownIn(path, drawingOnly) === path)
        .map(({ path, title }) => (
          <a
            key={path}
            href={path}
            aria-current={path === here ? "page" : undefined}
            onClick={(event) => {
              event.preventDefault();
              screen.go(path);
            }}
          >
            {t(title)}
          </a>
        ))}
      <ActionButton action={openPalette} size="small" look="plain" aria-label={openPalette.title}>
        ⋯
      </ActionButton>
    </nav>
  );
}
