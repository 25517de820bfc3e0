// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <kushi/mesh.h>
namespace kushi {
Mesh mannequin();
}
