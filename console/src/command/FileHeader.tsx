import { useState } from "react";
import { useSnapshot } from "../app/context";
import { useFiles } from "../operator/useFiles";
import { Button } from "../ui/Button";

/** Shows the job's facts from the head of the file, behind a mark. Nothing where the head holds none. */
export function FileHeader({ name }: { name: string }) {
  const folder = useSnapshot("folder")?.name ?? "";
  const wanted = folder === "" ? name.trim() : `${folder}/${name.trim()}`;
  const same = (other: string) => other.toLowerCase() === wanted.toLowerCase();
  const header = useFiles(folder).find((file) => same(file.name))?.header;
  const [shown, setShown] = useState(false);
  if (!header) return null;
  return (
    <div className="file-header">
      <Button
        size="small"
        aria-label="What the head of the file tells"
        aria-expanded={shown}
        onPress={() => setShown(!shown)}
      >
        <b aria-hidden="true">!</b>
      </Button>
      {shown && <pre>{header}</pre>}
    </div>
  );
}
