// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kushi/vec.h>

// The mannequin as implicit shapes in centimetres, in the axes of the head: negative inside.
// A trailing `a` is |z|: both halves are one.
namespace kushi {

double skullField(Vec3d p);
/// Joins brows, eyes, nose and mouth to the skull's value at p.
double withFace(Vec3d p, double skull);
/// Joins the ears.
double withEars(Vec3d p, double head);
double bustField(Vec3d p);

/// All of it.
double mannequinField(Vec3d p);

}  // namespace kushi
