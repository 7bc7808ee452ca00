import { useHands, useSnapshot } from "../app/context";
import { putJson } from "../link/http";
import { openToRun } from "../operator/openFile";
import { Thumbnail } from "../operator/Thumbnail";
import { Button } from "../ui/Button";
import { Sheet } from "../ui/Sheet";
import type { ToDo } from "../wire/messages";
import { t } from "../words/words";
import { earlier, wanting, withOneMore } from "./runs";
import { useKept } from "./useKept";

const address = "/api/todo";

/**
 * Files that are to be run, how often, and how often they were. Whoever made one opens the next: nothing starts by
 * itself.
 */
export function ToDoSheet({ onClose }: { onClose: () => void }) {
  const hands = useHands();
  const opened = useSnapshot("opened");
  const list = useKept<ToDo>(address);
  const put = (next: readonly ToDo[]) =>
    void putJson(address, next).catch((error: Error) => hands.screen.tell(error.message));
  if (!list) return null;
  const name = opened && opened.kind !== "drawing" ? opened.name : undefined;
  return (
    <Sheet
      title="Jobs to do"
      shape="wide"
      onClose={onClose}
      foot={
        <>
          <Button
            refused={list.some(isDone) ? undefined : t("Nothing on the list is done yet.")}
            onPress={() => put(list.filter((one) => !isDone(one)))}
          >
            Remove what is done
          </Button>
          <Button
            look="primary"
            refused={name === undefined ? t("Open a program or a job first.") : undefined}
            onPress={() => name !== undefined && put(withOneMore(list, name))}
          >
            Add the open file
          </Button>
        </>
      }
    >
      {list.length === 0 && <p className="tail-empty">{t("Nothing is to be done.")}</p>}
      <ol className="todo" aria-label={t("Jobs to do")}>
        {list.map((one, n) => (
          <ToDoRow key={one.file} one={one} first={n === 0} list={list} put={put} />
        ))}
      </ol>
    </Sheet>
  );
}

const isDone = ({ wanted, made }: ToDo): boolean => made >= wanted;

interface ToDoRowProps {
  one: ToDo;
  first: boolean;
  list: readonly ToDo[];
  put: (next: readonly ToDo[]) => void;
}

function ToDoRow({ one, first, list, put }: ToDoRowProps) {
  const hands = useHands();
  const folder = useSnapshot("folder")?.name ?? "";
  const { file, wanted, made } = one;
  return (
    <li className={isDone(one) ? "list-line todo-done" : "list-line"}>
      <Thumbnail name={file} />
      <b className="todo-name">{file}</b>
      <span>{t("{0} of {1} made", made, wanted)}</span>
      <Button
        size="small"
        aria-label={t("One less of {0}", file)}
        refused={wanted > 1 ? undefined : t("One at least is wanted; remove it.")}
        onPress={() => put(wanting(list, file, -1))}
      >
        −
      </Button>
      <Button
        size="small"
        aria-label={t("One more of {0}", file)}
        onPress={() => put(wanting(list, file, 1))}
      >
        +
      </Button>
      <Button
        size="small"
        aria-label={t("{0} earlier", file)}
        refused={first ? t("It is the first.") : undefined}
        onPress={() => put(earlier(list, file))}
      >
        ↑
      </Button>
      <Button
        size="small"
        aria-label={t("Open {0}", file)}
        onPress={() => void openToRun(hands, file, folder)}
      >
        Open
      </Button>
      <Button
        size="small"
        aria-label={t("Remove {0}", file)}
        onPress={() => put(list.filter((other) => other.file !== file))}
      >
        Remove
      </Button>
    </li>
  );
}
