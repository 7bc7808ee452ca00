import { version } from "../link/version";
import { Button } from "../ui/Button";
import "./guard.css";

/**
 * Stands in place of everything but STOP, hold and disarm where the server is of another version than this page:
 * what a button asks for may mean something else there.
 */
export function OtherVersion({ kerf }: { kerf: string }) {
  return (
    <section className="failed" role="alert">
      <h2>Kerf was changed: reload this page</h2>
      <p>
        This page is of Kerf {version}, and the machine is driven by Kerf {kerf}. STOP, Hold and
        Disarm work; nothing else does until the page is loaded again. A job goes on meanwhile.
      </p>
      <Button look="primary" onPress={() => location.reload()}>
        Reload
      </Button>
    </section>
  );
}
