// What is dropped or opened: motions of the hand, scenes, logs.

/** The first line tells what a file without a duration is. */
const head = ({ text }) => text.split("\n", 1)[0];
const isMotion = (file) => /^\s*t\s*,\s*rest\s*$/.test(head(file));
const isLog = (file) => !/^\s*duration\s*=/m.test(file.text) && /[,;\t]/.test(head(file));

/** The function that takes dropped files, each a name and a text: `keep` takes a motion and tells whether that opened a scene, `scene`
 *  takes the name and the text of a scene, `log` those of a log, both of which throw what they refuse; `done` tells of the files,
 *  in view or not. */
export function opener({ keep, scene, log, done }) {
  return (files) => {
    const motions = files.filter(isMotion);
    // Motions first, since a scene beside them names one.
    const isOpen = motions.map(({ name, text }) => keep(`${name}\n${text}`)).includes(true);
    const others = files.filter((it) => !isMotion(it));
    const file = others.pop();
    if (!file) {
      const names = motions.map(({ name }) => name).join(", ");
      if (names) done(`Kept as a motion of the hand, for scenes that name it: ${names}.`, !isOpen);
      return;
    }
    const left = others.length ? ` One file at a time: not opened: ${others.map(({ name }) => name).join(", ")}.` : "";
    try {
      if (isLog(file)) log(file, left);
      else scene(file, left);
    } catch (error) {
      done(error.message.replaceAll("the scene", () => file.name) + left);
    }
  };
}
