import { useState } from "react";
import { Button } from "../ui/Button";
import { Field } from "../ui/Field";
import { Sheet } from "../ui/Sheet";
import { t } from "../words/words";
import { withEnding } from "./document";

interface SaveAsProps {
  title?: string;
  /** The word on its button. */
  verb?: string;
  first: string;
  onSave: (name: string) => void;
  onCancel: () => void;
}

/** Asks for the name of a file in the part folder. */
export function SaveAs(props: SaveAsProps) {
  const { title = "Save as", verb = "Save", first, onSave, onCancel } = props;
  const [name, setName] = useState(first);
  const save = () => name.trim() !== "" && onSave(withEnding(name.trim()));
  return (
    <Sheet
      title={title}
      onClose={onCancel}
      foot={
        <Button
          look="primary"
          refused={name.trim() === "" ? t("Enter a name first.") : undefined}
          onPress={() => save()}
        >
          {verb}
        </Button>
      }
    >
      <form
        onSubmit={(event) => {
          event.preventDefault();
          save();
        }}
      >
        <Field
          label="Name in the part folder"
          value={name}
          onChange={setName}
          placeholder="part.sbp"
          first
        />
      </form>
    </Sheet>
  );
}
