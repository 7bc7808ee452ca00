import { useSnapshot } from "../app/context";
import { Panel } from "../ui/Panel";

/** What is kept with the drawing in words: material, customer, what the operator has to know. */
export function CommentPanel() {
  const comments = useSnapshot("drawing")?.comments ?? [];
  if (comments.length === 0) return null;
  return (
    <Panel title="Comments">
      <p className="drawing-comments">{comments.join("\n")}</p>
    </Panel>
  );
}
