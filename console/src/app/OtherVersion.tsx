import { version } from "../link/version";
import { Button } from "../ui/Button";
import { t } from "../words/words";
import "./guard.css";

/**
 * Stands in place of everything but STOP, hold and disarm where the server is of another version than this page:
 * what a button asks for may mean something else there.
 */
export function OtherVersion({ kerf }: { kerf: string }) {
  return (
    <section className="failed" role="alert">
      <h2>{t("Kerf was changed: reload this page")}</h2>
      <p>
        {t(
          "This page is of Kerf {0}, and the machine is driven by Kerf {1}. STOP, Hold and Disarm work; nothing else does until the page is loaded again. A job goes on meanwhile.",
          version,
          kerf,
        )}
      </p>
      <Button look="primary" onPress={() => location.reload()}>
        Reload
      </Button>
    </section>
  );
}
