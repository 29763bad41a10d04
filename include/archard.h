/* Includes all public headers of libarchard. Each header under archard/ can also be included
 * alone. */
#ifndef ARCHARD_H
#define ARCHARD_H

#include "archard/array.h"
#include "archard/base.h"
#include "archard/body.h"
#include "archard/contact.h"
#include "archard/export.h"
#include "archard/joint.h"
#include "archard/lock.h"
#include "archard/material.h"
#include "archard/measure.h"
#include "archard/mesh.h"
#include "archard/model.h"
#include "archard/atomic_file.h"
#include "archard/setting.h"
#include "archard/space.h"
#include "archard/store.h"
#include "archard/wear.h"
#include "archard/wear_settings.h"

#endif
