/** Long work in short tasks: others on the page get their turn between them. */

/** A task of such work lasts so long, milliseconds; a frame of the page is 16. */
const taskMs = 8;

/** Called between two steps of long work: lets others have their turn when the task has lasted long enough. */
export function takingTurns(): () => Promise<void> {
  let began = performance.now();
  return async () => {
    if (performance.now() - began < taskMs) return;
    await new Promise<void>((resolve) => setTimeout(resolve));
    began = performance.now();
  };
}
