import { useEffect, useState } from "react";
import { t } from "../words/words";
import { useHands } from "./context";
import "./drop-files.css";

/**
 * Files that are dragged onto the page go into the part folder, in the sheet that lists it. Without this the
 * browser would leave the console and show the file.
 */
export function DropFiles() {
  const { screen } = useHands();
  const [over, setOver] = useState(false);
  useEffect(() => {
    const drags = (event: DragEvent) => {
      const files = event.dataTransfer?.types.includes("Files") ?? false;
      if (files && !event.defaultPrevented) event.preventDefault();
      setOver(files);
    };
    const leaves = (event: DragEvent) => event.relatedTarget === null && setOver(false);
    const drops = (event: DragEvent) => {
      setOver(false);
      const given = [...(event.dataTransfer?.files ?? [])];
      // The editor takes what is dropped into its text.
      if (given.length === 0 || event.defaultPrevented) return;
      event.preventDefault();
      screen.open({ kind: "files", given });
    };
    addEventListener("dragover", drags);
    addEventListener("dragleave", leaves);
    addEventListener("drop", drops);
    return () => {
      removeEventListener("dragover", drags);
      removeEventListener("dragleave", leaves);
      removeEventListener("drop", drops);
    };
  }, [screen]);
  return (
    over && <p className="drop-files">{t("Let go: the files are sent into the part folder.")}</p>
  );
}
