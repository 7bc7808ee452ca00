import { useSnapshot } from "../app/context";
import { Panel } from "../ui/Panel";

/** The comments that are kept with the drawing: material, customer, what the operator has to know. */
export function CommentPanel() {
  const comments = useSnapshot("drawing")?.comments ?? [];
  if (comments.length === 0) return null;
  return (
    <Panel title="Comments">
      <p className="drawing-comments">{comments.join("\n")}</p>
    </Panel>
  );
}
