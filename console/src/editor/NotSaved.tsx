import { Button } from "../ui/Button";

interface NotSavedProps {
  /** Files whose text is not saved; a new one has an empty name. */
  names: readonly string[];
  onShow: (name: string) => void;
}

/** Other files with text that is not saved: one press goes back to it. */
export function NotSaved({ names, onShow }: NotSavedProps) {
  if (names.length === 0) return null;
  return (
    <p className="edit-others">
      Also not saved:
      {names.map((name) => (
        <Button key={name} size="small" onPress={() => onShow(name)}>
          {name || "New file"}
        </Button>
      ))}
    </p>
  );
}
