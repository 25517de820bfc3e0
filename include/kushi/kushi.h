// SPDX-License-Identifier: Apache-2.0
#pragma once

// Everything, in the order of the data's way.
#include <kushi/camera.h>
#include <kushi/cantilever.h>
#include <kushi/cantilevers.h>
#include <kushi/color.h>
#include <kushi/distance_field.h>
#include <kushi/draw.h>
#include <kushi/ellipsoid.h>
#include <kushi/fibre.h>
#include <kushi/follicles.h>
#include <kushi/groom_io.h>
#include <kushi/head.h>
#include <kushi/image.h>
#include <kushi/layered_image.h>
#include <kushi/mesh.h>
#include <kushi/mesh_io.h>
#include <kushi/pigment.h>
#include <kushi/planar_rod.h>
#include <kushi/push_out.h>
#include <kushi/rest_shape.h>
#include <kushi/result.h>
#include <kushi/rods.h>
#include <kushi/settle.h>
#include <kushi/settle_groom.h>
#include <kushi/shade.h>
#include <kushi/shadows.h>
#include <kushi/strands.h>
#include <kushi/style.h>
#include <kushi/subdivide.h>
#include <kushi/trace.h>
#include <kushi/vec.h>
