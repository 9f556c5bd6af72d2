//! Words of the command as Python has them: an option is an argument, a command a function.

/// Commands that are functions here.
const FUNCTIONS: [&str; 9] =
    ["accuracy", "bound", "compare", "explain", "map", "observe", "run", "scenes", "tune"];

/// Sentences that Python puts in another way.
const SENTENCES: [(&str, &str); 5] = [
    ("`lyapunov compare` takes it", "only the command takes it: `python -m lyapunov compare FILE`"),
    ("--out DIR or --json has them", "`table` has them"),
    ("with --columns", "with columns=\"T,X,F\""),
    ("saves the shipped file of that name", "is the shipped scene of that name"),
    ("give --columns the numbers of", "give columns=\"1,2,3\", the numbers of"),
];

/// A text of the command in the words of Python. What stands in backticks is code, and a command with options stays one.
pub(crate) fn of_python(text: &str) -> String {
    let text = SENTENCES.into_iter().fold(text.to_owned(), |text, (it, here)| put(&text, it, here));
    let parts = text.split('`').enumerate();
    let parts = parts.map(|(at, part)| if at % 2 == 1 { code(part) } else { arguments(part) });
    parts.collect::<Vec<_>>().join("`")
}

/// The text with `here` for each `sentence`, whose lines may have been broken anywhere.
fn put(text: &str, sentence: &str, here: &str) -> String {
    let behind = |from| {
        sentence.split(' ').try_fold(from, |it: &str, word| it.trim_start().strip_prefix(word))
    };
    let first = sentence.split(' ').next().unwrap_or_default();
    let found = text.match_indices(first).find_map(|(at, _)| Some((at, behind(&text[at..])?)));
    match found {
        Some((at, rest)) => format!("{}{here}{}", &text[..at], put(rest, sentence, here)),
        None => text.to_owned(),
    }
}

fn code(part: &str) -> String {
    let Some(call) = part.strip_prefix("lyapunov ") else { return part.to_owned() };
    let saved = call.strip_prefix("scenes ").and_then(|it| it.split_whitespace().next());
    match saved {
        Some(name) => format!("lyapunov.Scene.shipped({name:?})"),
        None if FUNCTIONS.contains(&call) => format!("lyapunov.{call}"),
        None => format!("python -m {part}"),
    }
}

/// Text outside of code, in which `--scale x=1e-3` becomes `scale="x=1e-3"`, `--late 2` `late=2` and `--columns` `columns`.
fn arguments(part: &str) -> String {
    let (mut told, mut rest) = (String::new(), part);
    while let Some((before, after)) = rest.split_once("--") {
        told += before;
        let is_letter = |it: char| it.is_ascii_lowercase() || it == '-';
        let (name, further) =
            after.split_at(after.find(|it| !is_letter(it)).unwrap_or(after.len()));
        let begins = told.chars().next_back().is_none_or(|it| it.is_whitespace() || it == '(');
        if !begins || !name.starts_with(|it: char| it.is_ascii_lowercase()) {
            (told, rest) = (told + "--", after);
            continue;
        }
        told += &name.replace('-', "_");
        // A line may have been broken before the value.
        let value = further.split_whitespace().next().unwrap_or_default();
        let value = value.trim_end_matches(['.', ',', ';', ':', ')']);
        let shown = match value.parse::<f64>() {
            _ if !further.starts_with(char::is_whitespace) => None,
            Ok(_) => Some(format!("={value}")),
            Err(_) => value.contains('=').then(|| format!("={value:?}")),
        };
        rest = match &shown {
            Some(_) => &further.trim_start()[value.len()..],
            None => further,
        };
        told += shown.as_deref().unwrap_or_default();
    }
    told + rest
}

/// The text about a log in memory, which has rows from 0 and no lines: the names of its columns were line 1.
pub(crate) fn of_rows(text: &str, log: &str) -> String {
    let text = text.replace(&format!("{log}:1: "), &format!("{log}: "));
    let text = numbered(&text, &format!("{log}:"), &format!("{log}, row "));
    ["line ", "line\n"].iter().fold(text, |text, line| numbered(&text, line, "row "))
}

/// The text with the number behind each `line` as that of a row.
fn numbered(text: &str, line: &str, row: &str) -> String {
    let mut parts = text.split(line);
    let mut told = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        // A line may be broken before a number; behind a colon a space means that it is another.
        let number = if line.ends_with(':') { part } else { part.trim_start() };
        let (number, after) =
            number.split_at(number.find(|it: char| !it.is_ascii_digit()).unwrap_or(number.len()));
        match number.parse::<u64>().ok().and_then(|number| number.checked_sub(2)) {
            Some(number) => told += &format!("{row}{number}{after}"),
            None => told += &format!("{line}{part}"),
        }
    }
    told
}
