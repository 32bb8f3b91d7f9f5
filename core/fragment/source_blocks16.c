/* fragment/source_blocks16.c: texture coordinates in perspective, a divide every 16 pixels. A
 * stage; see source_blocks.h. */
#include "source_blocks_parts.h"

void etch_source_texture_blocks16(struct etch_chunk *chunk, const void *data)
{
    (void)data;
    etch_source_in_blocks(chunk, 4);
}
