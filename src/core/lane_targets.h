// SPDX-License-Identifier: Apache-2.0
//
// What is not compiled of the instruction sets that Highway knows; before any of its headers. One
// target for each width of register is enough; under sanitizers, which make these files slow to
// compile, one beside the baseline.
#pragma once

#ifdef KUSHI_FEW_TARGETS
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_SSE4 | HWY_AVX3 | HWY_AVX3_DL)
#else
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3_DL)
#endif
