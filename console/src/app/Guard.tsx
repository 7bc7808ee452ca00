import { Component, type ReactNode } from "react";
import { Button } from "../ui/Button";
import { t } from "../words/words";
import "./guard.css";

interface Guarded {
  readonly children: ReactNode;
  /** Subject of the part: with another one it is tried again, and a part that did not fail stays as it is. */
  readonly about?: unknown;
  /** Stands in place of a part that failed; by default a panel that says so. */
  readonly instead?: ReactNode;
}

interface Failing {
  readonly why: string | null;
  readonly about?: unknown;
}

/**
 * Keeps a mistake of the page in the part that made it: without this all of the page would vanish, and STOP
 * with it. A part that is fetched when it is wanted fails too when the server has another version by then.
 */
export class Guard extends Component<Guarded, Failing> {
  override state: Failing = { why: null };

  static getDerivedStateFromProps({ about }: Guarded, now: Failing): Failing | null {
    return about === now.about ? null : { why: null, about };
  }

  static getDerivedStateFromError(error: unknown): Pick<Failing, "why"> {
    return { why: error instanceof Error ? error.message : String(error) };
  }

  override render(): ReactNode {
    const { why } = this.state;
    if (why === null) return this.props.children;
    return this.props.instead === undefined ? <Failed why={why} /> : this.props.instead;
  }
}

function Failed({ why }: { why: string }) {
  return (
    <section className="failed" role="alert">
      <h2>{t("This part of the page failed")}</h2>
      <p>
        {t(
          "The machine does not notice: what runs goes on, and STOP stops it. Loading the page again usually helps, most of all after Kerf was updated.",
        )}
      </p>
      <Button look="primary" onPress={() => location.reload()}>
        Load the page again
      </Button>
      <p className="failed-why">{why}</p>
    </section>
  );
}
