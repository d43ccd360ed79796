//! What a name tells of a submission: the assignment's own scheme, and those of Canvas and Moodle.

use crate::printable::printable;
use crate::{Lms, Student};

/// What the name of a file or folder tells.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Told {
    pub(crate) student: Student,
    pub(crate) lms: Lms,
    pub(crate) marked_late: bool,
}

/// What `stem`, a name without extension, tells. The schemes are:
///
/// - `300000001_TerryFox`, the assignment's own. The number has 5 to 12 digits, and may also stand at the end.
/// - Canvas: `foxterry_LATE_1234_56789_300000001_TerryFox-1`: the sortable name, perhaps `LATE`, the ids of the user and of the
///   file, and the name under which it was handed in, to which `-1` is added when it is handed in again. When names are
///   hidden `anon` and an anonymous id stand in front.
/// - Moodle: `Terry Fox_1234_assignsubmission_file`: the full name and the participant's number; the name under which it was
///   handed in may follow.
pub(crate) fn tell(stem: &str) -> Told {
    moodle(stem).or_else(|| canvas(stem)).unwrap_or_else(|| Told {
        student: own(stem).unwrap_or_else(|| Student { number: None, name: readable(stem) }),
        lms: Lms::None,
        marked_late: false,
    })
}

/// The student of a name in the assignment's own scheme.
pub(crate) fn own(stem: &str) -> Option<Student> {
    let stem = without_copy_number(stem);
    let separators = ['_', '-', ' '];
    let digits =
        |text: &str| (5..=12).contains(&text.len()) && text.bytes().all(|byte| byte.is_ascii_digit());
    let (number, name) = if digits(stem) {
        (stem, "")
    } else if let Some((number, name)) = stem.split_once(separators).filter(|(first, _)| digits(first)) {
        (number, name)
    } else {
        // `submission_123456789` is how Gradescope counts.
        let is_student =
            |(name, last): &(&str, &str)| digits(last) && !name.eq_ignore_ascii_case("submission");
        let (name, number) = stem.rsplit_once(separators).filter(is_student)?;
        (number, name)
    };
    Some(Student { number: Some(number.to_owned()), name: readable(name) })
}

/// A name without its extension, when it has one.
pub(crate) fn stem(file_name: &str) -> &str {
    match file_name.rsplit_once('.') {
        Some((stem, extension))
            if !stem.is_empty()
                && (1..=4).contains(&extension.len())
                && extension.bytes().all(|byte| byte.is_ascii_alphanumeric()) =>
        {
            stem
        }
        _ => file_name,
    }
}

fn moodle(stem: &str) -> Option<Told> {
    let (who, original) = stem.split_once("_assignsubmission_")?;
    let (name, participant) = who.rsplit_once('_').filter(|(_, id)| is_id(id))?;
    let number = original.strip_prefix("file_").and_then(own).and_then(|student| student.number);
    Some(Told {
        student: Student { number, name: readable(name) },
        lms: Lms::Moodle { participant: participant.to_owned() },
        marked_late: false,
    })
}

fn canvas(stem: &str) -> Option<Told> {
    let mut parts: Vec<&str> = stem.split('_').collect();
    let before = parts.len();
    // `LATE` is second or third.
    if let Some(at) =
        (1..before.min(3)).find(|at| parts.get(*at).is_some_and(|part| part.eq_ignore_ascii_case("late")))
    {
        parts.remove(at);
    }
    let marked_late = parts.len() < before;
    if let ["anon", id, original @ ..] = parts.as_slice()
        && !id.is_empty()
        && id.bytes().all(|byte| byte.is_ascii_alphanumeric())
        && !original.is_empty()
    {
        let original = if is_id(original.first()?) { original.get(1..)? } else { original };
        let student = own(&original.join("_"))
            .unwrap_or_else(|| Student { number: None, name: format!("anonymous {id}") });
        return Some(Told { student, lms: Lms::CanvasAnonymous { id: (*id).to_owned() }, marked_late });
    }
    let at = (1..parts.len().checked_sub(2)?)
        .find(|at| matches!(parts.get(*at..=at + 1), Some([user, file]) if is_id(user) && is_id(file)))?;
    let sortable = parts.get(..at)?.join("_");
    if sortable.is_empty() || own(&sortable).is_some() {
        return None;
    }
    let student = own(&parts.get(at + 2..)?.join("_")).filter(|student| !student.name.is_empty());
    Some(Told {
        student: student.unwrap_or_else(|| Student { number: None, name: readable(&sortable) }),
        lms: Lms::Canvas { user_id: (*parts.get(at)?).to_owned() },
        marked_late,
    })
}

fn is_id(text: &str) -> bool {
    (1..=20).contains(&text.len()) && text.bytes().all(|byte| byte.is_ascii_digit())
}

/// Without the `-1` of Canvas and the ` (1)` of browsers.
fn without_copy_number(stem: &str) -> &str {
    let is_count =
        |text: &str| (1..=2).contains(&text.len()) && text.bytes().all(|byte| byte.is_ascii_digit());
    if let Some((before, count)) = stem.rsplit_once('-')
        && is_count(count)
    {
        return before;
    }
    if let Some((before, count)) = stem.strip_suffix(')').and_then(|stem| stem.rsplit_once('('))
        && is_count(count)
    {
        return before.trim_end();
    }
    stem
}

fn readable(name: &str) -> String {
    printable(name.replace('_', " ").trim())
}
