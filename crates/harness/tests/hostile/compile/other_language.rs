//! A program in another language.
//!
//! place: alone
//! expect: does-not-compile

#include <GL/glut.h>
void computeLocalQuaternion(Joint *joint, float *frame) {
    joint->Localquat = QuaternionFromEuler(frame[0], frame[1], frame[2]);
}
