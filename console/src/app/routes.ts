/** The screens of the console and their addresses. */

import { t } from "../words/words";

export const routes = [
  { path: "/", title: t("Operate") },
  { path: "/edit", title: t("Edit") },
  { path: "/draw", title: t("Draw") },
  { path: "/settings", title: t("Settings") },
  { path: "/help", title: t("Help") },
] as const;

export type Route = (typeof routes)[number]["path"];

/** The route an address belongs to; unknown ones, and `/job` of earlier versions, lead to the operator's screen. */
export function routeOf(pathname: string): Route {
  const [, first = ""] = pathname.split("/");
  return routes.find((route) => route.path === `/${first}`)?.path ?? "/";
}

/** Screens of somebody who only draws. */
const drawing: readonly Route[] = ["/draw", "/edit", "/help"];

/** The screen that is shown: where the machine is left alone, none of the machine's. */
export const shownIn = (route: Route, drawingOnly: boolean): Route =>
  drawingOnly && !drawing.includes(route) ? "/draw" : route;
