import { Button } from "../ui/Button";
import type { TextDraft } from "../wire/messages";
import { phrase, t } from "../words/words";

interface NotSavedProps {
  /** Texts that are not saved; a new file has an empty name. */
  drafts: readonly TextDraft[];
  /** The file in the editor: another page may type into it too. */
  file: string;
  onShow: (draft: TextDraft) => void;
}

/** Other texts that are not saved: one press goes to it. */
export function NotSaved({ drafts, file, onShow }: NotSavedProps) {
  if (drafts.length === 0) return null;
  return (
    <p className="edit-others">
      {phrase(
        "Also not saved:{0}",
        drafts.map((draft) => (
          <Button key={`${draft.name} ${draft.page}`} size="small" onPress={() => onShow(draft)}>
            {draft.name || t("New file")}
            {draft.name === file && t(", another text")}
          </Button>
        )),
      )}
    </p>
  );
}
