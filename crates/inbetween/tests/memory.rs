//! Memory that is used again changes no pose.
#![allow(clippy::unwrap_used)] // Helpers of tests.

mod support;

use glam::Vec3;
use inbetween::{InbetweenClip, Scratch};
use proptest::collection::vec;
use proptest::prelude::*;
use skeleton::{Clip, Pose, Representation};
use support::{frames, motion};

proptest! {
    #[test]
    fn poses_do_not_depend_on_what_was_posed_before(
        motions in [motion(2..12), motion(2..12)],
        asked in vec((0_usize..2, 0_usize..12, 0_usize..12, 0_usize..12), 1..40),
    ) {
        let clip = |index: usize| {
            let motion = &motions[index];
            InbetweenClip::new(motion.skeleton(), &frames(motion), Representation::ALL[index])
        };
        let clips = [clip(0), clip(1)];
        let mut scratch = Scratch::default();
        let (mut pose, mut fresh) = (Pose::default(), Pose::default());
        for (index, start, end, frame) in asked {
            let clip = &clips[index];
            clip.between(start, end, frame, &mut pose);
            // A clone remembers nothing.
            clip.clone().between(start, end, frame, &mut fresh);
            prop_assert_eq!(&pose, &fresh);
            let tips = clip.tips_between(start, end, frame, &mut scratch);
            let mut unused = Scratch::default();
            prop_assert_eq!(tips, clip.tips_between(start, end, frame, &mut unused));
            // The pose and the tips are the same to the last bit: an error is the same whoever calculates it.
            let parents: Vec<usize> = clip.skeleton().joints().iter().filter_map(|joint| Some(joint.parent?.0)).collect();
            let is_tip = |id: &usize| !parents.contains(id);
            let expected: Vec<Vec3> = (0..pose.len()).filter(is_tip).map(|id| pose.transforms()[id].position).collect();
            prop_assert_eq!(tips, expected);
            let local = clip.local_between(start, end, frame);
            let roots = clip.skeleton().joints().iter().filter(|joint| joint.is_root());
            for root in roots {
                prop_assert_eq!(local.positions[root.id.0], pose[root.id].position);
                prop_assert_eq!(local.rotations[root.id.0], pose[root.id].rotation);
            }
        }
    }
}

#[test]
fn tips_take_no_new_memory() {
    let text = include_bytes!("../../../data/dance.bvh");
    let motion = parser::bvh::read(&text[..]).unwrap().motion;
    for representation in Representation::ALL {
        let clip = InbetweenClip::new(motion.skeleton(), &frames(&motion), representation);
        let mut scratch = Scratch::default();
        clip.tips_between(0, 9, 4, &mut scratch);
        let allocated = allocation_counter::measure(|| {
            for end in (2..141).step_by(3) {
                for frame in 1..end {
                    clip.tips_between(0, end, frame, &mut scratch);
                }
            }
        });
        assert_eq!(allocated.count_total, 0, "{representation}");
    }
}

#[test]
fn two_threads_do_not_disturb_one_another() {
    let text = include_bytes!("../../../data/dance.bvh");
    let motion = parser::bvh::read(&text[..]).unwrap().motion;
    let clip = &InbetweenClip::new(motion.skeleton(), &frames(&motion), Representation::Quaternion);
    let poses = |end: usize| {
        let pose = |frame| {
            let mut pose = Pose::default();
            clip.between(0, end, frame, &mut pose);
            pose
        };
        (1..end).map(pose).collect::<Vec<Pose>>()
    };
    let alone = [poses(140), poses(139)];
    let together = std::thread::scope(|scope| {
        [140, 139].map(|end| scope.spawn(move || poses(end))).map(|thread| thread.join().unwrap())
    });
    assert!(alone == together);
}
