//! Pictures and tables of error curves.

use super::*;

fn golden() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests").join("golden").join("error.csv")
}

/// Sines differ in the last bit between systems: errors are compared as numbers, everything else letter by letter.
/// `FK_LAB_BLESS=1` writes the table again.
#[test]
fn the_table_of_a_small_motion_is_the_known_one() {
    let folder = Folder::new();
    let (file, csv) = (folder.text("arm.bvh"), folder.text("error.csv"));
    fs::write(&file, arm(9)).unwrap();
    let (said, complaints) = run(&[&file, "--csv", &csv, "--keyframes", "2"]).unwrap();
    assert_eq!((said, complaints), (format!("{csv}: 8 rows of numbers\n"), String::new()));
    let now = fs::read_to_string(&csv).unwrap();
    if std::env::var_os("FK_LAB_BLESS").is_some() {
        fs::write(golden(), &now).unwrap();
    }
    let then = fs::read_to_string(golden()).unwrap();
    assert_eq!(now.lines().next(), then.lines().next());
    assert_eq!(now.lines().count(), then.lines().count());
    for (now, then) in now.lines().zip(then.lines()).skip(1) {
        let cells = now.split(',').zip(then.split(',')).enumerate();
        for (column, (a, b)) in cells {
            match (column, a.parse::<f64>(), b.parse::<f64>()) {
                (1 | 2, Ok(a), Ok(b)) => assert!((a - b).abs() <= 1e-4 * b.abs(), "{now}, was {then}"),
                _ => assert_eq!(a, b, "{now}, was {then}"),
            }
        }
    }
}

#[test]
fn the_table_is_what_the_curves_say() {
    let folder = Folder::new();
    let (csv, plot) = (folder.text("error.csv"), folder.text("error.SVG"));
    let (said, _) = run(&[&data("dance.bvh"), "--csv", &csv, "--plot", &plot]).unwrap();
    assert_eq!(
        said,
        format!("{plot}: both curves, up to 121 interpolated frames\n{csv}: 122 rows of numbers\n")
    );
    let motion = read(data("dance.bvh"));
    let curves = skeleton::Representation::ALL.map(|representation| {
        let errors = reduction::Errors::new(motion.skeleton(), &frames(&motion), representation);
        reduction::curve(&errors, 20, &mut |_, _| std::ops::ControlFlow::Continue(()))
    });
    let text = fs::read_to_string(&csv).unwrap();
    let rows: Vec<Vec<&str>> = text.lines().skip(1).map(|line| line.split(',').collect()).collect();
    assert_eq!(rows.len(), 122);
    for (count, row) in rows.iter().enumerate() {
        assert_eq!(row[0], count.to_string());
        for (at, curve) in curves.iter().enumerate() {
            assert_eq!(row[1 + at].parse::<f64>().unwrap(), curve.errors[count]);
            let removed = count.checked_sub(1).map(|last| curve.removed[last].to_string());
            assert_eq!(row[3 + at], removed.unwrap_or_default());
        }
    }
}

#[test]
fn the_picture_names_the_motion_whatever_it_is_called() {
    let folder = Folder::new();
    let name = if cfg!(windows) { "a & b.bvh" } else { "a <b> & \"c\" \u{1b}[31m.bvh" };
    let (file, plot) = (folder.text(name), folder.text("error.svg"));
    fs::write(&file, arm(9)).unwrap();
    run(&[&file, "--plot", &plot, "--keyframes", "3"]).unwrap();
    let svg = fs::read_to_string(&plot).unwrap();
    assert!(svg.contains("Accumulated error of a ") && svg.contains(" &amp; "), "{svg}");
    assert!(svg.contains("interpolated frames, of 9") && !svg.contains(['\u{1b}']) && !svg.contains("<b>"));
    assert_eq!(svg.matches('<').count(), svg.matches('>').count());
}

#[test]
fn errors_that_are_too_large_to_be_drawn_are_told() {
    let folder = Folder::new();
    let (file, plot) = (folder.text("arm.bvh"), folder.text("error.svg"));
    fs::write(&file, arm(9).replace("OFFSET 0 5 0", "OFFSET 0 3e38 0")).unwrap();
    let told = run(&[&file, "--plot", &plot, "--keyframes", "3"]).unwrap_err();
    assert!(told.contains("too large to be drawn"), "{told}");
    assert_eq!(folder.names(), ["arm.bvh"]);
}

#[test]
fn help_names_the_options_under_a_heading_and_still_begins_with_the_viewer() {
    let output = view(&["--help"]);
    let help = String::from_utf8(output.stdout).unwrap();
    assert!(help.starts_with("Shows a motion moved by YOUR functions"), "{help}");
    let (_, motions) = help.split_once("New motions:").unwrap();
    let (motions, curves) =
        motions.split_once("Keyframes (in files, the reference solution chooses and interpolates):").unwrap();
    let options: [(&str, &[&str]); 2] = [
        (motions, &["--out", "--overwrite"]),
        (curves, &["--plot", "--csv", "--keyframes", "--mode", "--method"]),
    ];
    for (section, options) in options {
        options.iter().for_each(|option| {
            assert!(
                section.contains(&format!("{option} ")) || section.contains(&format!("{option}\n")),
                "{option}"
            )
        });
        assert!(!section.contains("--positions"), "an option stands under the wrong heading");
    }
}
