/* Available memory. */
#ifndef BASE_MEMORY_H
#define BASE_MEMORY_H

/* Memory [bytes] available to this process by machine, control group and limits; INFINITY if
 * unknown. */
double arc_memory_free(void);

#endif
