//! Few frames, many frames, and odd numbers of keyframes.

use super::*;

#[test]
fn every_count_gives_the_obvious_for_every_length() {
    let folder = Folder::new();
    let (file, out) = (folder.text("arm.bvh"), folder.text("out.bvh"));
    let (plot, csv) = (folder.text("error.svg"), folder.text("error.csv"));
    for frames in [1, 2, 3, 9] {
        fs::write(&file, arm(frames)).unwrap();
        for count in ["0", "1", "2", "3", "9", "10", "18446744073709551615"] {
            for method in ["greedy", "moves", "optimum", "even"] {
                let wanted = ["--out", &out, "--plot", &plot, "--csv", &csv, "--overwrite"];
                let options = ["--keyframes", count, "--method", method];
                let (said, complaints) = run(&[&[&*file], &wanted[..], &options].concat()).unwrap();
                assert_eq!(complaints, "");
                let asked: usize = count.parse().unwrap();
                let kept = asked.clamp(2, 9).min(frames);
                let keyframes = keyframes(&said);
                assert_eq!(keyframes.len(), kept, "{said}");
                assert_eq!((keyframes[0], keyframes[kept - 1]), (0, frames - 1));
                assert_eq!(said.contains("always stay"), asked < kept, "{said}");
                assert_eq!(fs::read_to_string(&csv).unwrap().lines().count(), 2 + frames - kept);
                assert!(fs::read_to_string(&plot).unwrap().contains("</svg>"));
                if kept == frames {
                    assert_eq!(read(&out), read(&file));
                    assert_eq!(number(&said, "accumulated error"), 0.0);
                }
            }
        }
    }
    for wrong in ["-1", "1.5", "many", "18446744073709551616"] {
        assert_eq!(view(&[&file, "--csv", &csv, "--keyframes", wrong]).status.code(), Some(2));
    }
}

#[test]
fn a_motion_without_frames_has_no_keyframes() {
    let folder = Folder::new();
    let file = folder.text("rest.bvh");
    fs::write(&file, arm(0)).unwrap();
    for wanted in [["--out", "out.bvh"], ["--plot", "error.svg"], ["--csv", "error.csv"]] {
        let told = run(&[&file, wanted[0], &folder.text(wanted[1])]).unwrap_err();
        assert_eq!(told, "rest.bvh: there are no frames, and so no keyframes\n");
    }
    assert_eq!(folder.names(), ["rest.bvh"]);
}

#[test]
fn an_optimum_that_would_take_too_long_is_refused_at_once() {
    let folder = Folder::new();
    let (file, out) = (folder.text("long.bvh"), folder.text("out.bvh"));
    fs::write(&file, arm(20_000)).unwrap();
    let told = run(&[&file, "--out", &out, "--method", "optimum"]).unwrap_err();
    assert_eq!(
        told,
        "long.bvh: to find the best 20 keyframes of 20000 frames would take too long; --method moves comes close to them\n"
    );
    assert_eq!(folder.names(), ["long.bvh"]);
}
