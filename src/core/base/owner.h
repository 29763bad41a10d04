/* core/owner.h - identification of programs in file names, for shared disks. */
#ifndef CORE_OWNER_H
#define CORE_OWNER_H

/* Length of such a name, with the zero. */
enum { ARC_OWNER = 40 };

/* Name of this program, "SYSTEM-PID"; SYSTEM changes with a restart of the system. */
void arc_owner_name(char name[ARC_OWNER]);

typedef enum arc_owner_state {
  ARC_OWNER_GONE,
  ARC_OWNER_LIVES,
  ARC_OWNER_ELSEWHERE /* unknown: on another system, or not a name */
} arc_owner_state;

/* State of the program whose name starts a text; a character other than a letter or digit ends the
 * name. */
arc_owner_state arc_owner_look(const char *name);

#endif
