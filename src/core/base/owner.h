/* core/owner.h - identification of programs in file names, for shared disks. */
#ifndef CORE_OWNER_H
#define CORE_OWNER_H

/* Size of the name of a program with its final zero. */
enum { ARC_OWNER = 40 };

/* Writes the name of this program, "SYSTEM-PID". SYSTEM changes with a restart of the system. */
void arc_owner_name(char name[ARC_OWNER]);

typedef enum arc_owner_state {
  ARC_OWNER_GONE,
  ARC_OWNER_LIVES,
  ARC_OWNER_ELSEWHERE /* unknown, as the program is on another system or the text is not a name */
} arc_owner_state;

/* Returns the state of the program whose name is at the beginning of a text. A character other than
 * a letter or digit ends the name. */
arc_owner_state arc_owner_look(const char *name);

#endif
