import { useEffect, useState, useSyncExternalStore } from "react";
import { createStore } from "../app/store";
import { type Loading, loadToolPath, type ToolPath } from "./toolPath";

const nothing = createStore<ToolPath | null>(null);

/** The tool path of a preview as it arrives. */
export function useToolPath(key: string | undefined): ToolPath | null {
  const [loading, setLoading] = useState<Loading | null>(null);
  useEffect(() => {
    if (key === undefined) return;
    const next = loadToolPath(key);
    setLoading(next);
    return () => {
      next.cancel();
      setLoading(null);
    };
  }, [key]);
  const store = loading?.path ?? nothing;
  return useSyncExternalStore(store.watch, store.get);
}
