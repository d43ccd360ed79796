//! What must become of a submission, and whether it did.

use serde_json::Value;

/// One or several verdicts, any of which is right: machines differ in what runs out first.
///
/// `graded 10; part1 panicked "words"`, `does-not-compile "words"`, `too-expensive-to-compile time`, `rejected link`,
/// with ` | ` between them. The words occur somewhere in the record.
#[derive(Clone, Debug)]
pub struct Expected {
    text: String,
    any: Vec<One>,
}

#[derive(Clone, Debug)]
struct One {
    status: String,
    /// The points, the limit or the code.
    detail: Option<String>,
    parts: Vec<(String, String)>,
    words: Option<String>,
}

impl Expected {
    pub fn parse(text: &str) -> Result<Expected, String> {
        let any = text.split(" | ").map(One::parse).collect::<Result<_, _>>()?;
        Ok(Expected { text: text.to_owned(), any })
    }

    pub fn text(&self) -> &str {
        &self.text
    }

    /// The same with every word run through `change`.
    pub fn map_words(mut self, change: impl Fn(&str) -> String) -> Expected {
        for one in &mut self.any {
            one.words = one.words.as_deref().map(&change);
        }
        self
    }

    /// Whether all that is allowed is a verdict with at most the given points lost by time: then it is known how long it may
    /// take.
    pub fn runs_out_of_time(&self) -> bool {
        let is_time = |one: &One| {
            one.status == "too-expensive-to-compile"
                || one.parts.iter().any(|(_, state)| state == "timed-out")
        };
        self.any.iter().any(is_time)
    }

    pub fn is_met_by(&self, record: &Value) -> bool {
        self.any.iter().any(|one| one.is_met_by(record))
    }
}

impl One {
    fn parse(text: &str) -> Result<One, String> {
        let (text, words) = match text.split_once('"') {
            Some((text, words)) => (text, Some(words.strip_suffix('"').ok_or("no second quote")?.to_owned())),
            None => (text, None),
        };
        let mut pieces = text.trim().split("; ");
        let mut first = pieces.next().unwrap_or_default().splitn(2, ' ');
        let status = first.next().unwrap_or_default().to_owned();
        let known = ["graded", "does-not-compile", "too-expensive-to-compile", "rejected"];
        if !known.contains(&&*status) {
            return Err(format!("unknown verdict {status:?}"));
        }
        let detail = first.next().map(str::to_owned);
        let part = |piece: &str| {
            let (part, state) = piece.split_once(' ').ok_or_else(|| format!("no state in {piece:?}"))?;
            Ok((part.to_owned(), state.to_owned()))
        };
        Ok(One { status, detail, parts: pieces.map(part).collect::<Result<_, String>>()?, words })
    }

    fn is_met_by(&self, record: &Value) -> bool {
        let verdict = &record["verdict"];
        let detail = match &*self.status {
            "graded" => points(record).map(|points| points.to_string()),
            "too-expensive-to-compile" => verdict["limit"].as_str().map(str::to_owned),
            "rejected" => verdict["code"].as_str().map(str::to_owned),
            _ => None,
        };
        let has_state = |(id, state): &(String, String)| {
            let parts = verdict["parts"].as_array().into_iter().flatten();
            parts.into_iter().any(|part| part["id"] == **id && part["state"] == **state)
        };
        verdict["status"] == *self.status
            && (self.detail.is_none() || self.detail == detail)
            && self.parts.iter().all(has_state)
            && self.words.as_ref().is_none_or(|words| strings(record).any(|text| text.contains(words)))
    }
}

/// The points of a graded submission.
pub fn points(record: &Value) -> Option<u64> {
    let parts = record["verdict"]["parts"].as_array()?;
    Some(parts.iter().filter_map(|part| part["points"].as_u64()).sum())
}

/// The verdict in one line, for the message of a test.
pub fn brief(record: &Value) -> String {
    let verdict = &record["verdict"];
    let mut text = verdict["status"].as_str().unwrap_or("no status").to_owned();
    if let Some(points) = points(record) {
        text.push_str(&format!(" {points}"));
    }
    for key in ["limit", "code", "why", "what"] {
        if let Some(detail) = verdict[key].as_str() {
            text.push_str(&format!(" {detail}"));
        }
    }
    for part in verdict["parts"].as_array().into_iter().flatten() {
        text.push_str(&format!(
            "; {} {}",
            part["id"].as_str().unwrap_or(""),
            part["state"].as_str().unwrap_or("")
        ));
    }
    let notes = strings(&verdict["parts"]).filter(|text| text.starts_with("your code"));
    let errors =
        verdict["errors"].as_array().into_iter().flatten().filter_map(|error| error["message"].as_str());
    for words in notes.chain(errors).take(2) {
        text.push_str(&format!(" ({})", words.chars().take(300).collect::<String>()));
    }
    text
}

fn strings(value: &Value) -> Box<dyn Iterator<Item = &str> + '_> {
    match value {
        Value::String(text) => Box::new(std::iter::once(text.as_str())),
        Value::Array(values) => Box::new(values.iter().flat_map(strings)),
        Value::Object(fields) => Box::new(fields.values().flat_map(strings)),
        _ => Box::new(std::iter::empty()),
    }
}
