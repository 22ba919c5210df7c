// OpenNI2's driver interface, with the few macros that its package forgets to define.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <new>

#ifndef XN_NEW
#define XN_NEW(type, arg) new type(arg)
#endif
#ifndef XN_DELETE
#define XN_DELETE(pointer) delete (pointer)
#endif
#ifndef TRUE
#define TRUE 1
#endif
#ifndef FALSE
#define FALSE 0
#endif

#include <Driver/OniDriverAPI.h>
