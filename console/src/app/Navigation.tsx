import { useHands, useScreen } from "./context";
import { routes } from "./routes";
import "./navigation.css";

export function Navigation() {
  const { screen } = useHands();
  const here = useScreen("route");
  return (
    <nav className="nav" aria-label="Screens">
      <img className="nav-mark" src="/kerf.svg" alt="Kerf" width="28" height="28" />
      {routes.map(({ path, title }) => (
        <a
          key={path}
          href={path}
          aria-current={path === here ? "page" : undefined}
          onClick={(event) => {
            event.preventDefault();
            screen.go(path);
          }}
        >
          {title}
        </a>
      ))}
    </nav>
  );
}
