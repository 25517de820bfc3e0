// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kushi/result.h>
#include <kushi/strands.h>

#include <string>

namespace kushi {

/// Whether any strand format could hold `strands`: offsets and attributes complete, no strand
/// without a node, every number finite (also in centimetres) and in its range.
Status checkWritable(const Strands& strands, const std::string& file);

}  // namespace kushi
