// SPDX-License-Identifier: Apache-2.0
// What a shared library shows to the outside: functions and classes marked CDSM_API, and nothing else.
#pragma once

#if defined(__GNUC__)
#define CDSM_API __attribute__((visibility("default")))
#else
#define CDSM_API
#endif
