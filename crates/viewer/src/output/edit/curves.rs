//! The numbers behind the error curves.

use std::io::{self, Write};

use reduction::Curve;

/// Writes both curves as CSV: one row for each number of interpolated frames, from none on, with the accumulated errors and the
/// frames that were removed last.
///
/// Errors are in the file's unit, squared, in the fewest digits that read back as the same number. Where one curve is longer,
/// the other's cells are empty.
///
/// # Errors
///
/// When `out` fails.
pub fn write_csv(euler: &Curve, quaternions: &Curve, out: &mut dyn Write) -> io::Result<()> {
    const HEADER: [&str; 5] = [
        "interpolated frames",
        "error with Euler angles (squared file units)",
        "error with quaternions (squared file units)",
        "frame removed with Euler angles (from 0)",
        "frame removed with quaternions (from 0)",
    ];
    writeln!(out, "{}", HEADER.join(","))?;
    for count in 0..euler.errors.len().max(quaternions.errors.len()) {
        let error = |curve: &Curve| curve.errors.get(count).map(f64::to_string).unwrap_or_default();
        let removed = |curve: &Curve| {
            let last = count.checked_sub(1).and_then(|last| curve.removed.get(last));
            last.map(usize::to_string).unwrap_or_default()
        };
        let (errors, frames) = ([euler, quaternions].map(error), [euler, quaternions].map(removed));
        writeln!(out, "{count},{},{},{},{}", errors[0], errors[1], frames[0], frames[1])?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_hold_errors_and_what_was_removed() {
        let euler = Curve { removed: vec![3, 1], errors: vec![0.0, 0.5, 0.25] };
        let quaternions = Curve { removed: vec![2], errors: vec![0.0, 1e-7] };
        let mut text = Vec::new();
        write_csv(&euler, &quaternions, &mut text).unwrap();
        let text = String::from_utf8(text).unwrap();
        let rows: Vec<&str> = text.lines().skip(1).collect();
        assert_eq!(rows, ["0,0,0,,", "1,0.5,0.0000001,3,2", "2,0.25,,1,"]);
        assert!(text.lines().next().unwrap().split(',').count() == 5);
    }
}
