/* core/owner.h - programs as names of files tell of them, wherever a disk is shared. */
#ifndef CORE_OWNER_H
#define CORE_OWNER_H

/* Length of such a name, with the zero. */
enum { ARC_OWNER = 40 };

/* This program, "SYSTEM-PID": the system counts as another one once it was started again. */
void arc_owner_name(char name[ARC_OWNER]);

typedef enum arc_owner_state {
  ARC_OWNER_GONE,
  ARC_OWNER_LIVES,
  ARC_OWNER_ELSEWHERE /* on another system, or no name at all: nobody here can tell */
} arc_owner_state;

/* Of a text that begins with such a name, ended by anything but a letter or digit. */
arc_owner_state arc_owner_look(const char *name);

#endif
