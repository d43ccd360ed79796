//! Names for submissions that are safe as file names everywhere.

use std::collections::{HashMap, HashSet};

use crate::source::sha256;

/// The longest id. Long names are cut.
const MAX_LEN: usize = 80;

/// How many hexadecimal digits of the name's hash tell apart what else would be the same.
const HASH_LEN: usize = 8;

/// An id for each of `names`, in their order: the name, with `_` for what a file name should not hold. Where that loses
/// something, or two would be the same, the beginning of the name's hash follows.
///
/// A submission's id depends on no other one, unless their names are the same but for what is lost and the extension.
pub(crate) fn make_ids(names: &[(&str, &str)]) -> Vec<String> {
    let made: Vec<Made> = names.iter().map(|(stem, _)| make(stem)).collect();
    let mut count: HashMap<String, usize> = HashMap::new();
    for one in &made {
        *count.entry(one.id.to_ascii_lowercase()).or_default() += 1;
    }
    let mut taken = HashSet::new();
    let mut copies: HashMap<String, usize> = HashMap::new();
    let mut ids = Vec::new();
    for ((_, name), one) in names.iter().zip(&made) {
        let is_shared = count.get(&one.id.to_ascii_lowercase()).is_some_and(|count| *count > 1);
        let plain =
            if one.is_lossy || is_shared { with_suffix(&one.id, &hash(name)) } else { one.id.clone() };
        let mut id = plain.clone();
        let copy = copies.entry(plain.to_ascii_lowercase()).or_insert(1);
        while !taken.insert(id.to_ascii_lowercase()) {
            *copy += 1;
            id = with_suffix(&plain, &copy.to_string());
        }
        ids.push(id);
    }
    ids
}

struct Made {
    id: String,
    is_lossy: bool,
}

fn make(stem: &str) -> Made {
    let mut id = String::new();
    let mut is_lossy = false;
    for c in stem.chars() {
        let is_safe = c.is_ascii_alphanumeric() || matches!(c, '_' | '-' | '.');
        // A space is the one loss that matters to nobody.
        is_lossy |= !is_safe && c != ' ';
        let c = if is_safe { c } else { '_' };
        if c != '_' || !id.ends_with('_') {
            id.push(c);
        }
    }
    let trimmed = id.trim_matches(['.', '-', '_']);
    is_lossy |= trimmed.len() < id.len() || trimmed.len() > MAX_LEN;
    let id = if trimmed.is_empty() { "submission" } else { trimmed };
    Made { is_lossy: is_lossy || is_reserved(id) || trimmed.is_empty(), id: id.to_owned() }
}

/// Windows knows devices by these names, with any extension.
fn is_reserved(id: &str) -> bool {
    let name = id.split('.').next().unwrap_or_default().to_ascii_uppercase();
    let numbered = |kind| {
        name.strip_prefix(kind)
            .is_some_and(|rest: &str| rest.len() == 1 && rest.bytes().all(|byte| byte.is_ascii_digit()))
    };
    matches!(name.as_str(), "CON" | "PRN" | "AUX" | "NUL") || numbered("COM") || numbered("LPT")
}

fn hash(name: &str) -> String {
    sha256(name.as_bytes()).chars().take(HASH_LEN).collect()
}

/// `id` and `suffix`, with the id cut where both would be too long. A device's name comes to stand in one part with the suffix.
fn with_suffix(id: &str, suffix: &str) -> String {
    let id: String = id.chars().take(MAX_LEN - suffix.len() - 1).collect();
    if is_reserved(&id) { format!("{}-{suffix}", id.replace('.', "_")) } else { format!("{id}-{suffix}") }
}
